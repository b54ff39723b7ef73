"""Says what ctest's log knows of the tests that its entries ran (tools/test).

    python3 test_report.py BUILD

Of each entry that failed, prints the output without the tests that passed: a
test that crashed or never ended is the last that ran. Then counts the tests: an
entry that is no GoogleTest or unittest program counts as one.
"""

import re
import sys
from pathlib import Path

ENTRY = re.compile(r"^\d+/\d+ Test: (?P<name>.*?)$.*?^-{58}$\n(?P<output>.*?)"
                   r"<end of output>$.*?^Test (?P<verdict>\w+)\.$", re.M | re.S)
PASSED = re.compile(r"^\[ RUN      \] (\S+)\n(?:.*\n)*?\[       OK \] \1[ ,].*\n"
                    r"|^\[-{10}\].*\n\n?", re.M)
GOOGLE = re.compile(r"^\[  (PASSED|FAILED|SKIPPED) ?\s*\] (\d+) tests?[,.]",
                    re.M)
PYTHON = re.compile(r"^Ran (\d+) tests? in ", re.M)
BAD = re.compile(r"\b(failures|errors|skipped)=(\d+)")


def google_counts(output):
    """The counts of a GoogleTest program that came to its end, else none."""
    return {kind.lower(): int(count) for kind, count in GOOGLE.findall(output)}


def python_counts(output):
    """The same of a program of Python's unittest."""
    ran = PYTHON.search(output)
    if not ran:
        return {}
    verdict = output[ran.end():]
    bad = {kind: int(count) for kind, count in BAD.findall(verdict)}
    failed = bad.get("failures", 0) + bad.get("errors", 0)
    skipped = bad.get("skipped", 0)
    return {"passed": int(ran[1]) - failed - skipped, "failed": failed,
            "skipped": skipped}


def counts_of(entry):
    failed = entry["verdict"] != "Passed"
    counts = (google_counts(entry["output"]) or python_counts(entry["output"])
              or {"passed": int(not failed)})
    # A program may also fail at its end, after all of its tests.
    counts["failed"] = max(counts.get("failed", 0), int(failed))
    return counts


def shown(entry):
    return f"== {entry['name']}\n{PASSED.sub('', entry['output'])}"


def report(log):
    total = {"passed": 0, "failed": 0, "skipped": 0}
    for entry in ENTRY.finditer(log):
        if entry["verdict"] != "Passed":
            yield shown(entry)
        for kind, count in counts_of(entry).items():
            total[kind] += count
    yield ", ".join(f"{count} {kind}" for kind, count in total.items()
                    if count or kind != "skipped")


if __name__ == "__main__":
    LOG = Path(sys.argv[1], "Testing/Temporary/LastTest.log")
    for part in report(LOG.read_text(encoding="utf-8", errors="replace")):
        print(part)
