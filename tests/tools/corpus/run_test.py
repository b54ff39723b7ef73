#!/usr/bin/env python3
"""Tests tools/corpus/run with small samples in the data sets' formats: the
applications it makes, its scores, and what it reports for wrong answers."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
DATA = pathlib.Path(__file__).resolve().parent
RUN = ROOT / "tools/corpus/run"
PARLOUR = pathlib.Path(os.environ.get("PARLOUR_PROGRAM",
                                      ROOT / "build/debug/bin/parlour"))
RUNNER = PARLOUR.with_name("corpus_runner")


def run(*arguments):
    command = [sys.executable, "-B", str(RUN), *map(str, arguments),
               "--runner", str(RUNNER)]
    return subprocess.run(command, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)


class WithFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def copy(self, name):
        return pathlib.Path(shutil.copytree(DATA / name, self.folder / name))


@unittest.skipUnless(RUNNER.exists(), "corpus_runner is not built")
class Sgd(WithFolder):
    def play(self, change=None, *options):
        """With the first dialogue only, changed first."""
        folder = self.copy("sgd")
        file = folder / "dev/dialogues_001.json"
        dialogues = json.loads(file.read_text("utf-8"))
        if change:
            change(dialogues[0])
        file.write_text(json.dumps(dialogues), "utf-8")
        return run("sgd", folder, "--limit", 1, *options)

    def test_states_are_right_and_returns_keep_their_slots(self):
        done = self.play()
        self.assertIn("right turns      100.0000%", done.stdout)
        self.assertIn("returns          1 of 1 with", done.stdout)
        self.assertIn("dead ends        0", done.stdout)
        self.assertRegex(done.stdout, r"given by state   1 ")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_wrong_slot_is_told_and_misses_the_bar(self):
        def change(dialogue):  # the engine takes the default: "oars"
            for turn in dialogue["turns"][8:11:2]:
                values = turn["frames"][0]["state"]["slot_values"]
                values["kind"] = ["sail"]
        done = self.play(change, "--list")
        self.assertIn("wrong: return 8 Boats_1 kind: wanted 'sail', "
                      "found 'oars'", done.stdout)
        self.assertEqual(done.returncode, 1)

    def test_contradictions_are_listed_by_rule(self):
        done = run("sgd", DATA / "sgd", "--list")
        listed = [line.removeprefix("contradiction: contradictory ")
                  for line in done.stdout.splitlines()
                  if line.startswith("contradiction: ")]
        self.assertEqual(listed, [
            "0 Trams_1 day: the state does not take a value that the user "
            "gave",
            "2 Trams_1 from: the state has a value that nobody has said",
            "2 Trams_1 stop: the state changes a value that nobody spoke of",
            "4 Boats_1 kind: a value is none of those that the schema lists",
            "6 Boats_1 lake: the state loses a value that nobody took back"])
        self.assertIn("100.0000% where the data does not contradict itself",
                      done.stdout)

    def test_the_application_is_an_ordinary_one(self):
        self.play(None, "--keep", self.folder / "made")
        checked = subprocess.run([str(PARLOUR), "check",
                                  str(self.folder / "made/dev")], text=True,
                                 stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, check=False)
        self.assertIn("0 errors, 0 warnings", checked.stdout)

    def test_a_folder_without_dialogues_is_an_error(self):
        done = run("sgd", self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no dialogues in", done.stdout)


@unittest.skipUnless(RUNNER.exists(), "corpus_runner is not built")
class FinancialDemo(WithFolder):
    def test_stories_pass(self):
        done = run("financial-demo", DATA / "demo", "--list")
        self.assertIn("stories          4 of 4", done.stdout)
        self.assertIn("returns          2 of 2 with", done.stdout)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_story_that_goes_otherwise_fails(self):
        folder = self.copy("demo")
        file = folder / "tests/test_stories.yml"
        file.write_text(re.sub("action: action_rent$", "action: action_sell",
                               file.read_text("utf-8"), flags=re.M), "utf-8")
        done = run("financial-demo", folder, "--list")
        self.assertIn("unsaid: a question within a form 2: "
                      "wanted 'action_sell'", done.stdout)
        self.assertIn("stories          3 of 4", done.stdout)
        self.assertEqual(done.returncode, 1)


if __name__ == "__main__":
    unittest.main()
