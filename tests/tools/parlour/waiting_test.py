#!/usr/bin/env python3
"""Tests timers, and handlers that wait for the user: in `parlour run` with
pipes, in virtual and in real time, and in `parlour test`."""

import subprocess
import unittest

from program_case import PROGRAM, ProgramCase

SCRIPT = """<dialogue>
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <if cond="length(_LPARAM1) lt 5">
        <confirm question="Did you say {_LPARAM1}?"><no><consume/><return/></no></confirm>
      </if>
      <post module="NLU" command="DoNLU" param="_LPARAM1"/>
    </RecognitionResult></ASR>
    <NLU><FrameInfo><fire param="_LPARAMS"/></FrameInfo></NLU>
  </component></messages></handler>
  <topic name="Tea">
    <examples><value>make some tea</value><value>tea</value></examples>
    <completed>
      <timer name="tea" after="10m"><speak param="Your tea is ready."/></timer>
      <speak param="In ten minutes."/>
    </completed>
  </topic>
  <topic name="Egg">
    <examples><value>boil an egg for me</value></examples>
    <completed>
      <timer name="egg" after="5m" keeps-open="false"><speak param="Your egg is ready."/></timer>
      <speak param="In five minutes."/>
    </completed>
  </topic>
</dialogue>"""

SETTINGS = """<settings>
  <Plugins><Plugin>GrammarNLU</Plugin></Plugins>
  <Scripts><Script>kitchen.xml</Script></Scripts>
</settings>"""

LOST = "the timer '{}' is lost with its session; it was due at {}"


class Waiting(ProgramCase):

    def setUp(self):
        super().setUp()
        self.write("settings.xml", SETTINGS)
        self.write("kitchen.xml", SCRIPT)

    def run_with(self, words, *arguments):
        """What is said, and what is told beside it."""
        done = subprocess.run(
            [PROGRAM, "run", str(self.folder), "--data",
             str(self.folder / "data"), *arguments],
            input=words, capture_output=True, text=True, timeout=60,
            check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.splitlines(), done.stderr

    def in_virtual_time(self, words):
        return self.run_with(words, "--clock", "2026-11-21 09:00")

    def test_a_timer_keeps_the_conversation_open(self):
        said, told = self.in_virtual_time("make some tea\n\n\n")
        self.assertEqual(said, ["In ten minutes.", "Your tea is ready."])
        self.assertNotIn("lost", told)

    def test_what_is_due_at_the_end_of_the_input_is_lost_and_told(self):
        for words in "make some tea", "make some tea\n", "make some tea\n\n":
            said, told = self.in_virtual_time(words)
            self.assertEqual(said, ["In ten minutes."])
            self.assertIn(LOST.format("tea", "2026-11-21 09:10:00"), told)

    def test_the_end_of_the_input_waits_for_no_timer_in_real_time(self):
        said, told = self.run_with("make some tea\n")
        self.assertEqual(said, ["In ten minutes."])
        self.assertIn("the timer 'tea' is lost with its session", told)

    def test_one_that_may_be_lost_keeps_nothing_open(self):
        said, told = self.in_virtual_time("boil an egg for me\n\n\n")
        self.assertEqual(said, ["In five minutes."])
        self.assertIn(LOST.format("egg", "2026-11-21 09:05:00"), told)

    def test_words_that_are_confirmed_are_answered(self):
        said, _ = self.in_virtual_time("tea\n\nyes\n\ntea\n\ntee\n\nno\n")
        self.assertEqual(said, ["Did you say tea?", "In ten minutes.",
                                "Did you say tea?", "Did you say tee?"])

    def test_conversations_are_held_in_virtual_time(self):
        self.write("dialogues/late.txt", """U: tea
R: Did you say tea?
U: yes
R: In ten minutes.
wait 9m
U: boil an egg for me
R: In five minutes.
wait 1m
R: Your tea is ready.
""")
        done = subprocess.run([PROGRAM, "test", str(self.folder), "--quiet"],
                              capture_output=True, text=True, timeout=60,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
