#!/usr/bin/env python3
"""Tests `parlour test` when the program crashes or ends early: it names the
conversations that were running and fails. Also the names of processes."""

import pathlib
import signal
import subprocess
import unittest

from program_case import PROGRAM, ProgramCase

PLUGINS = pathlib.Path(PROGRAM).resolve().parents[1] / "plugins"
SETTINGS = """<settings name="robot" start="Hall">
  <Plugins><Plugin>Abrupt</Plugin></Plugins>
  <component name="Abrupt"{host}/>
  <Scripts><Script>robot.xml</Script></Scripts>
</settings>"""
SCRIPT = """<dialogue>
  <state name="Hall">
    <Entrance><speak param="Hello."/></Entrance>
    <Messages><component><ASR><RecognitionResult>
      <post module="Robot" command="Goto" param="'kitchen'"/>
    </RecognitionResult></ASR></component></Messages>
  </state>
</dialogue>"""


@unittest.skipUnless((PLUGINS / "Abrupt.so").exists(), "no sample plug-ins")
class Crash(ProgramCase):

    def setUp(self):
        super().setUp()
        self.application()
        self.write("dialogues/calm.txt", "R: Hello.\n")
        self.write("dialogues/crash.txt", "R: Hello.\nU: go\nwait 1s\n")

    def application(self, host=""):
        self.write("settings.xml", SETTINGS.format(host=host))
        self.write("robot.xml", SCRIPT)

    def test_of_a_test_names_the_conversations_that_were_held(self):
        ended = subprocess.run(
            [PROGRAM, "test", self.folder, "--plugins", PLUGINS, "-j", "1"],
            capture_output=True, timeout=60, check=False, encoding="utf-8")
        self.assertEqual(ended.returncode, -signal.SIGABRT)
        self.assertEqual(
            ended.stderr.splitlines()[-1],
            "error: the program ended while these were held: "
            f"{self.folder}/dialogues/crash.txt; parlour test APP FILE holds "
            "one alone")

    def test_nothing_is_named_where_all_went_well(self):
        ended = subprocess.run(
            [PROGRAM, "test", self.folder, "--plugins", PLUGINS, "-q", "calm"],
            capture_output=True, timeout=60, check=False, encoding="utf-8")
        self.assertEqual((ended.returncode, ended.stdout, ended.stderr),
                         (0, "1 of 1 conversations passed\n", ""))

    def test_a_process_of_its_own_is_called_parlour(self):
        self.application(' host="process"')
        running = self.begin(
            "run", self.folder, "--plugins", PLUGINS, "--text", "--data",
            self.folder / "data", stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(running.stdout.readline(), b"Hello.\n")
        children = pathlib.Path(
            f"/proc/{running.pid}/task/{running.pid}/children")
        processes = [child for task in children.parents[1].iterdir()
                     for child in (task / "children").read_text().split()]
        names = []
        for process in processes:
            folder = pathlib.Path("/proc") / process
            names.append((folder / "comm").read_text().strip())
            self.assertTrue((folder / "cmdline").read_bytes().startswith(
                b"parlour\0component\0Abrupt\0"))
        self.assertEqual(names, ["parlour"])
        running.stdin.close()
        self.assertEqual(running.wait(60), 0)


if __name__ == "__main__":
    unittest.main()
