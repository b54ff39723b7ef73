"""Runs corpus_runner on lines and takes in what it tells."""

import collections
import pathlib
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

Fault = collections.namedtuple(
    "Fault", "kind dialogue turn topic slot wanted found")
COUNTS = "dialogues turns states slots returns".split()


def program():
    """The newest build's runner."""
    built = [ROOT / "build" / preset / "bin" / "corpus_runner"
             for preset in ("release", "debug")]
    built = [file for file in built if file.exists()]
    if not built:
        raise SystemExit("build it first: tools/build release corpus_runner")
    return max(built, key=lambda file: file.stat().st_mtime)


class Results:
    """What was told of all that was played so far."""

    def __init__(self, runner, application):
        self.command = [str(runner), str(application)]
        self.counts = collections.Counter()
        self.faults = []
        self.seconds = 0.0

    def play(self, dialogues):
        """`dialogues`: the lines of each."""
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
        """The dialogue that was begun last."""
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
