#!/usr/bin/env python3
"""The soak of recovery with few visitors and kills; and that it can fail."""

import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import soak

PROGRAM = os.environ["PARLOUR_PROGRAM"]


class Recovery(unittest.TestCase):

    def test_nothing_is_lost_or_done_twice(self):
        done = subprocess.run(
            [sys.executable, "-B", soak.__file__, PROGRAM, "--visitors", "20",
             "--bookings", "10", "--kills", "5", "--between", "0.05", "0.3",
             "--pause", "0.3", "--replay"], capture_output=True, text=True,
            timeout=240, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        kills = int(re.search(r"(\d+) kills", done.stdout)[1])
        self.assertGreaterEqual(kills, 2, done.stdout)

    def visitor(self):
        visitor = soak.Visitor(1, 1, 0, 0)
        visitor.heard = [list(said) for said in visitor.expected]
        return visitor

    def test_what_is_missing_is_noticed(self):
        self.assertEqual(self.visitor().judge(), [])
        visitor = self.visitor()
        visitor.heard[0] = []
        self.assertIn("turn 1: heard []", visitor.judge()[0])

    def test_what_is_said_twice_is_noticed(self):
        visitor = self.visitor()
        for output in (7, 7, 8):  # 7 is repeated, 8 is another one
            visitor.take({"type": "say", "turn": 2, "output": output,
                          "text": "Booked."})
        self.assertEqual(visitor.heard[1][1:], ["Booked.", "Booked."])
        self.assertIn("turn 2", visitor.judge()[0])


if __name__ == "__main__":
    unittest.main()
