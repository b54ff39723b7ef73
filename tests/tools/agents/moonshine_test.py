#!/usr/bin/env python3
"""The program of the neural recogniser, without its weights: runs
moonshine_test.mjs."""

import pathlib
import shutil
import subprocess
import unittest

NODE = shutil.which("node")


class Moonshine(unittest.TestCase):
    @unittest.skipUnless(NODE, "node is not installed: it is untested")
    def test_passes_its_own_tests(self):
        tests = pathlib.Path(__file__).with_suffix(".mjs")
        done = subprocess.run([NODE, "--test", tests], timeout=120,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
