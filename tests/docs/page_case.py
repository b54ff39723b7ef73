"""Tests the examples of a page in docs/: writes its files, runs its commands and
compares what they print.

The info string of a fenced block says what to do: `file=NAME` writes a file,
`add=NAME` inserts before the last line of a file, `sh` runs commands, and `text`
is what the commands before it must print (a line `…` matches any lines)."""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).parents[2]
PROGRAM = Path(os.environ.get(
    "PARLOUR_PROGRAM", ROOT / "build" / "debug" / "bin" / "parlour"))


def blocks_of(page):
    """(info string, text) of each fenced block."""
    return re.findall(r"^```([^\n]*)\n(.*?)^```$", page, re.M | re.S)


@unittest.skipUnless(PROGRAM.exists(), "parlour is not built")
class PageCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.work = Path(self.folder.name) / "work"
        self.work.mkdir()
        commands = Path(self.folder.name) / "bin"
        commands.mkdir()
        (commands / "parlour").symlink_to(PROGRAM.resolve())
        self.environment = {
            **os.environ,
            "PATH": f"{commands}:{os.environ['PATH']}",
            "XDG_DATA_HOME": self.folder.name,
        }

    def run_commands(self, commands):
        done = subprocess.run(
            ["bash", "-eu", "-c", commands], cwd=self.work, text=True,
            env=self.environment, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, timeout=240, check=False)
        self.assertEqual(done.returncode, 0, commands + done.stdout)
        return done.stdout

    def add(self, name, text):
        file = self.work / name
        *lines, last = file.read_text(encoding="utf-8").splitlines()
        file.write_text("\n".join([*lines, "", text + last, ""]),
                        encoding="utf-8")

    def compare(self, printed, text):
        pattern = re.escape(text).replace("…\\\n", r"(?:.*\n)*")
        if not re.fullmatch(pattern, printed):
            self.assertEqual(printed, text)

    def try_out(self, name):
        """Tests the page; returns the number of comparisons."""
        page = (ROOT / "docs" / name).read_text(encoding="utf-8")
        printed = ""
        compared = 0
        for info, text in blocks_of(page):
            language, _, target = info.partition(" ")
            kind, _, file = target.partition("=")
            if kind == "file":
                (self.work / file).parent.mkdir(parents=True, exist_ok=True)
                (self.work / file).write_text(text, encoding="utf-8")
            elif kind == "add":
                self.add(file, text)
            elif language == "sh":
                printed = self.run_commands(text)
            elif language == "text":
                self.compare(printed, text)
                compared += 1
        return compared
