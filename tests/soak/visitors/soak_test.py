#!/usr/bin/env python3
"""The soak of visitors for some seconds; and that it can fail."""

import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import soak

PROGRAM = os.environ["PARLOUR_PROGRAM"]
RECEPTIONIST = (pathlib.Path(__file__).parents[3] /
                "config/apps/receptionist").resolve()
RIGHT = "10 conversations, 30 turns in 1 s\n0 wrong answers, 0 errors\n"


class Visitors(unittest.TestCase):

    def test_are_answered_while_it_is_loaded_again(self):
        # Memory is still growing then: lingering sessions.
        done = subprocess.run(
            [sys.executable, "-B", soak.__file__, PROGRAM, str(RECEPTIONIST),
             "--seconds", "6", "--rate", "10", "--reload-every", "2",
             "--kill-every", "1", "--journal"], capture_output=True, text=True, timeout=200,
            check=False)
        told = [line for line in done.stdout.splitlines()
                if line.startswith("FAILED") and "memory" not in line]
        self.assertEqual(told, [], done.stdout + done.stderr)
        reloads, kills = re.search(r"(\d+) reloads, (\d+) processes",
                                   done.stdout).groups()
        self.assertGreater(int(reloads), 0, done.stdout)
        self.assertGreater(int(kills), 0, done.stdout)

    def test_all_is_well(self):
        self.assertEqual(soak.judge(RIGHT, [(0, 90), (1, 100), (10, 105)], 10),
                         [])

    def test_a_wrong_answer_is_noticed(self):
        wrong = RIGHT.replace("0 wrong", "1 wrong")
        self.assertIn("visitors", soak.judge(wrong, [(1, 1), (10, 1)], 10)[0])

    def test_memory_that_grows_is_noticed(self):
        self.assertEqual(soak.judge(RIGHT, [(1, 100), (10, 120)], 10),
                         ["memory: 100 KiB, later 120 KiB"])


if __name__ == "__main__":
    unittest.main()
