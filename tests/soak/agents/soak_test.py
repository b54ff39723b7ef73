#!/usr/bin/env python3
"""The soak test of remote agents with few messages: each agent, over
connections that are cut some twenty times, or killed as often."""

import concurrent.futures
import os
import pathlib
import shutil
import unittest

import soak

PROGRAMS = str(pathlib.Path(os.environ.get("PARLOUR_PROGRAM", "")).parent)
# How many cuts there are depends on how fast the machine is.
FEW = ["--programs", PROGRAMS, "--cuts", "20", "--at-least", "10", "--seed", "2",
       "--pause", "0.05", "--patience", "240"]
SOAKS = {
    "C++": ["--agent", "cpp", "--messages", "6000"],
    "Python": ["--agent", "python", "--messages", "6000"],
    "Python, killed": ["--agent", "stored", "--messages", "5000"],
    "Python by ZeroMQ": ["--agent", "python", "--transport", "zeromq",
                         "--messages", "6000"],
}
if shutil.which("node"):
    SOAKS["Node.js"] = ["--agent", "node", "--messages", "6000"]
if not soak.python_with("zmq"):
    del SOAKS["Python by ZeroMQ"]


class SoakTest(unittest.TestCase):
    def test_loses_nothing_and_repeats_nothing(self):
        with concurrent.futures.ThreadPoolExecutor(len(SOAKS)) as pool:
            runs = {name: pool.submit(
                soak.Soak(soak.options_of([*FEW, *arguments])).run)
                    for name, arguments in SOAKS.items()}
        for name, run in runs.items():
            with self.subTest(name):
                self.assertEqual(run.result()["wrong"], [], run.result())


if __name__ == "__main__":
    unittest.main()
