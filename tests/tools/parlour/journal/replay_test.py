#!/usr/bin/env python3
"""Tests `parlour run --journal` and `parlour replay`: what was said is said
again, word by word, also after the run was killed; what is private is not
shown."""

import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import PROGRAM, ProgramCase  # noqa: E402

SCRIPT = """<dialogue>
  <state name="Hall"><Entrance><speak param="Good morning."/></Entrance></state>
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <post module="NLU" command="DoNLU" param="_LPARAM1"/>
    </RecognitionResult></ASR>
    <NLU><FrameInfo><fire param="_LPARAMS"/></FrameInfo></NLU>
  </component></messages></handler>
  <topic name="Tea">
    <examples><value>make some tea</value><value>tea</value></examples>
    <completed><speak param="Tea number {random(1, 1000000)}."/></completed>
  </topic>
  <topic name="Safe">
    <examples><value>open the safe</value><value>unlock the safe</value>
    </examples>
    <slot name="Code" type="Functional" private="true" question="Which code?">
      <cardinality type="number"/></slot>
    <completed><speak param="I try {this.Code}."/></completed>
  </topic>
</dialogue>"""

SETTINGS = """<settings start="Hall">
  <Plugins><Plugin>GrammarNLU</Plugin></Plugins>
  <Scripts><Script>kitchen.xml</Script></Scripts>
</settings>"""


class Replay(ProgramCase):

    def setUp(self):
        super().setUp()
        self.write("app/settings.xml", SETTINGS)
        self.write("app/kitchen.xml", SCRIPT)

    def run_of(self, *turns):
        return subprocess.run(
            [PROGRAM, "run", "app", "--text", "--data", "data", "--journal",
             "kept"], cwd=self.folder, input="".join(f"{turn}\n" for turn in
                                                     turns),
            capture_output=True, text=True, timeout=120, check=False)

    def replay(self, *arguments):
        return subprocess.run([PROGRAM, "replay", "app", "kept", *arguments],
                              cwd=self.folder, capture_output=True, text=True,
                              timeout=120, check=False)

    def test_says_again_what_was_said(self):
        said = self.run_of("tea", "tea")
        self.assertEqual(said.returncode, 0, said.stderr)
        again = self.replay()
        self.assertEqual(again.returncode, 0, again.stderr)
        robot = [line[3:] for line in again.stdout.splitlines()
                 if line.startswith("R: ")]
        self.assertEqual(robot, said.stdout.splitlines())
        self.assertEqual(len(set(robot)), 3, robot)
        self.assertIn("1 of 1 sessions are the same", again.stdout)

    def test_two_runs_share_a_journal(self):
        self.run_of("tea")
        self.run_of("tea", "tea")
        again = self.replay()
        self.assertIn("2 of 2 sessions are the same", again.stdout)
        session = re.findall(r"session (\w+)", again.stdout)[1]
        self.assertIn("1 of 1 sessions", self.replay(session).stdout)

    def test_what_was_said_before_a_kill_is_kept(self):
        running = self.begin(
            "run", "app", "--text", "--data", "data", "--journal", "kept",
            cwd=self.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL, text=True)
        self.assertEqual(running.stdout.readline(), "Good morning.\n")
        running.stdin.write("tea\n")
        running.stdin.flush()
        first = running.stdout.readline().strip()
        running.stdin.write("tea\n")
        running.stdin.flush()
        running.stdout.readline()
        # It is written some milliseconds after it was said.
        deadline = time.monotonic() + 60
        while (f"R: {first}" not in self.replay().stdout and
               time.monotonic() < deadline):
            pass
        running.send_signal(signal.SIGKILL)
        running.wait()
        again = self.replay()
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn(f"R: {first}", again.stdout)
        self.assertEqual(self.run_of("tea").returncode, 0)

    def test_shows_nothing_that_is_private(self):
        said = self.run_of("open the safe", "", "4711")
        self.assertIn("4711", said.stdout)
        for again in (self.replay(), self.replay("--trace")):
            self.assertIn("U: ***", again.stdout)
            self.assertNotIn("4711", again.stdout)
        inputs = int(re.search(r"(\d+) inputs", self.replay().stdout)[1])
        for until in range(inputs):
            self.assertNotIn("4711",
                             self.replay("--until", str(until)).stdout, until)

    def test_says_that_the_scripts_have_changed(self):
        self.run_of("tea")
        self.write("app/kitchen.xml", SCRIPT.replace("Good", "Nice"))
        again = self.replay()
        self.assertEqual(again.returncode, 1)
        self.assertIn("its scripts have changed", again.stderr)

    def test_says_what_is_no_journal(self):
        self.write("kept/000001.journal", "a letter")
        self.assertEqual(self.replay().returncode, 1)
        self.assertIn("no part of a journal", self.replay().stderr)
        run = self.run_of("tea")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("no part of a journal", run.stderr)

    def test_a_folder_that_cannot_be(self):
        self.write("kept", "a letter")
        run = self.run_of("tea")
        self.assertEqual(run.returncode, 1)
        self.assertIn("cannot be opened", run.stderr)

    def begin_run(self, *options):
        return self.begin(
            "run", "app", "--text", "--data", "data", "--journal", "kept",
            *options, cwd=self.folder, stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def say(self, running, line):
        running.stdin.write(line + "\n")
        running.stdin.flush()
        return running.stdout.readline().strip()

    def test_goes_on_where_it_was_killed(self):
        running = self.begin_run("--strict")
        self.assertEqual(running.stdout.readline(), "Good morning.\n")
        self.assertEqual(self.say(running, "open the safe"), "Which code?")
        running.send_signal(signal.SIGKILL)
        running.wait()
        again = self.begin_run("--strict")
        # What was asked last is asked again, and what is said is its answer.
        self.assertEqual(again.stdout.readline(), "Which code?\n")
        self.assertEqual(self.say(again, "4711"), "I try 4711.")
        again.stdin.close()
        again.wait()
        self.assertIn("the conversation goes on", again.stderr.read())
        whole = self.replay()
        self.assertIn("1 of 1 sessions are the same", whole.stdout)
        # It ended, so that the next run begins anew.
        self.assertIn("Good morning.", self.run_of("tea").stdout)

    def test_a_conversation_becomes_a_test(self):
        self.run_of("tea", "tea")
        made = subprocess.run(
            [PROGRAM, "journal", "export", "app", "kept"], cwd=self.folder,
            capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.write("app/dialogues/real.txt", made.stdout)
        tested = subprocess.run(
            [PROGRAM, "test", "--quiet", "app"], cwd=self.folder,
            capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(tested.returncode, 0, tested.stdout + tested.stderr)
        self.assertIn("1 of 1 conversations passed", tested.stdout)

    def test_strict_needs_a_journal(self):
        run = subprocess.run([PROGRAM, "run", "app", "--strict"],
                             cwd=self.folder, capture_output=True, text=True,
                             timeout=120, check=False)
        self.assertEqual(run.returncode, 2)
        self.assertIn("--journal", run.stderr)


if __name__ == "__main__":
    unittest.main()
