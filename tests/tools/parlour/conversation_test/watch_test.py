#!/usr/bin/env python3
"""Tests `parlour test --watch`: it runs again whenever a file changes."""

import pathlib
import signal
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import PROGRAM, ProgramCase  # noqa: E402

SETTINGS = """<settings name="echo" start="Hello">
  <Plugins/><Scripts><Script>echo.xml</Script></Scripts>
</settings>"""
SCRIPT = """<dialogue>
  <state name="Hello"><Entrance><speak param="WORDS"/></Entrance></state>
</dialogue>"""
CONVERSATION = "R: Hello.\n"


class Watch(ProgramCase):

    def setUp(self):
        super().setUp()
        self.write("settings.xml", SETTINGS)
        self.say("Hello.")
        self.write("dialogues/hello.txt", CONVERSATION)

    def say(self, words):
        self.write("echo.xml", SCRIPT.replace("WORDS", words))

    def start(self, *options):
        return self.begin(
            "test", str(self.folder), "--watch", "--quiet", *options,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            encoding="utf-8")

    def until(self, running, words):
        """Reads on until a round in which these words are printed."""
        printed = []
        while True:
            line = running.stdout.readline()
            self.assertTrue(line, (words, printed))
            printed.append(line)
            if line.startswith("waiting for changes"):
                if any(words in one for one in printed):
                    return "".join(printed)
                printed = []

    def end(self, running):
        running.send_signal(signal.SIGINT)
        self.assertEqual(running.wait(60), 130)

    def test_again_when_a_script_or_a_conversation_changes(self):
        running = self.start()
        self.until(running, "1 of 1 conversations passed")
        self.say("Hi.")
        self.until(running, "found:    R: Hi.")
        self.write("dialogues/hello.txt", "R: Hi.\n")
        self.until(running, "1 of 1 conversations passed")
        self.write("echo.xml", "<dialogue>")
        self.until(running, "error: ")
        self.say("Hi.")
        self.until(running, "1 of 1 conversations passed")
        self.write("topics/new.xml", "<dialogue/>")
        self.until(running, "1 of 1 conversations passed")
        self.end(running)

    def test_an_update_is_written_once(self):
        self.say("Good day.")
        running = self.start("--update")
        self.until(running, "UPDATED")
        self.assertNotIn("UPDATED", self.until(running, "1 of 1"))
        text = (self.folder / "dialogues/hello.txt").read_text()
        self.assertEqual(text, "R: Good day.\n")
        self.end(running)

    def test_an_application_that_is_not_there(self):
        ended = subprocess.run([PROGRAM, "test", "nowhere", "--watch"],
                               capture_output=True, timeout=60, check=False)
        self.assertEqual(ended.returncode, 2)


if __name__ == "__main__":
    unittest.main()
