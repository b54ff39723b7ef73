"""What the checks share: the list of files, and how findings are printed."""

import os
import sys
from pathlib import Path

ROOMS = ("runtime", "script", "actors", "adapters", "config", "tests", "tools")
CODE = (".hpp", ".cpp")
# In an additional git work tree, .git is a file.
SKIPPED = {"build", "__pycache__", ".git"}


def root():
    """The root of the tree to check: the first argument, or this tree."""
    named = [word for word in sys.argv[1:] if not word.startswith("--")]
    return Path(named[0] if named else Path(__file__).parents[2]).resolve()


def files(top, *suffixes):
    """All files with these suffixes, as sorted paths relative to `top`. Skips
    build folders and hidden folders."""
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
    """Prints the findings and exits: with 1 if there are any, else with 0."""
    for finding in findings:
        print(finding)
    sys.exit(1 if findings else 0)
