"""Runs corpus_runner on the lines of dialogues and collects its results. The
lines are those of tools/corpus/turns.hpp."""

import collections
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

Fault = collections.namedtuple(
    "Fault", "kind dialogue turn topic slot wanted found")
COUNTS = "dialogues turns states slots returns".split()


def program():
    """The path of the runner, which is built if it is missing or too old."""
    subprocess.run([ROOT / "tools/build", "release", "corpus_runner"],
                   check=True, stdout=sys.stderr)
    return ROOT / "build/release/bin/corpus_runner"


class Results:
    """The results of all dialogues that were played so far with one
    application."""

    def __init__(self, runner, application):
        self.command = [str(runner), str(application)]
        self.counts = collections.Counter()
        self.faults = []
        self.seconds = 0.0

    def play(self, dialogues):
        """Plays dialogues, each of which is a list of lines, in one process.
        If it crashes, the dialogues after the crash are not played."""
        text = "".join("\t".join(map(str, line)) + "\n"
                       for lines in dialogues for line in lines)
        begun = time.monotonic()
        ran = subprocess.run(self.command, input=text, check=False,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             encoding="utf-8")
        self.seconds += time.monotonic() - begun
        if ran.returncode == 2:
            raise SystemExit(ran.stderr)
        last = self._read(ran.stdout)
        if ran.returncode:
            self.faults.append(Fault("crash", last, "", "", "", "",
                                     f"exit status {ran.returncode}"))

    def _read(self, text):
        """Collects counts and faults from the output of the runner. Returns the
        dialogue that was begun last: in a crash it is the guilty one."""
        last = ""
        for line in filter(None, text.split("\n")):
            kind, *fields = line.split("\t")
            if kind == "begin":
                last = fields[0]
            elif kind == "total":
                self.counts.update(dict(zip(COUNTS, map(int, fields))))
            else:
                self.faults.append(Fault(kind, *fields))
        return last
