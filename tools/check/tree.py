"""What the checks share: the files of the tree and how findings are told."""

import os
import sys
from pathlib import Path

ROOMS = ("runtime", "script", "actors", "adapters", "config", "tests", "tools")
CODE = (".hpp", ".cpp")
# .git is a file where the tree is one of several work trees.
SKIPPED = {"build", "__pycache__", ".git"}


def root():
    """The tree to look at: the first argument, or the one we are in."""
    named = [word for word in sys.argv[1:] if not word.startswith("--")]
    return Path(named[0] if named else Path(__file__).parents[2]).resolve()


def files(top, *suffixes):
    """Paths relative to `top`, sorted, without build and hidden folders."""
    found = []
    for folder, folders, names in os.walk(top):
        folders[:] = [f for f in folders
                      if f not in SKIPPED and not f.startswith(".")]
        found += [Path(folder, name).relative_to(top) for name in names
                  if name not in SKIPPED
                  and (not suffixes or name.endswith(suffixes))]
    return sorted(found)


def lines(path):
    return path.read_text(encoding="utf-8", errors="replace").splitlines()


def finish(findings):
    """Prints findings; the exit code says whether there were any."""
    for finding in findings:
        print(finding)
    sys.exit(1 if findings else 0)
