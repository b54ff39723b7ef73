#!/usr/bin/env python3
"""Tests that the program prints the trace of docs/engine.md, and that the page
explains each of its lines by rules that exist."""

import re
import unittest

from page_case import PageCase, ROOT, blocks_of

PAGE = (ROOT / "docs" / "engine.md").read_text(encoding="utf-8")
TRACE = PAGE[PAGE.index("\n## 8. "):]
# | line | what happens | rule |
EXPLANATION = re.compile(r"^\| (\d[\d, –]*) \| .* \| ([\d., a-d()]+) \|$",
                         re.M)


def numbers(cell):
    """Of "4, 5" or "9–11"."""
    for part in cell.split(", "):
        first, _, last = part.partition("–")
        yield from range(int(first), int(last or first) + 1)


class EngineTest(PageCase):
    def test_the_trace_is_the_one_that_the_program_prints(self):
        shown, command = [], ""
        for info, text in blocks_of(TRACE):
            if info == "sh":
                command = text
            elif command:
                shown += re.findall(r"^ *\d+  (.*)$", text, re.M)
        printed = self.run_commands(
            f"cd '{ROOT}'\n{{\n{command}}} 2>&1 >/dev/null").splitlines()
        for expected, found in zip(shown, printed):
            pattern = re.escape(expected).replace("…", ".*")
            if not re.fullmatch(pattern, found.rstrip()):
                self.assertEqual(found, expected)
        self.assertEqual(len(shown), len(printed))


class ExplanationTest(unittest.TestCase):
    def test_each_line_is_explained_once_and_in_order(self):
        shown = [int(number) for _, text in blocks_of(TRACE)
                 for number in re.findall(r"^ *(\d+)  ", text, re.M)]
        self.assertGreater(len(shown), 50)
        self.assertEqual(shown, list(range(1, len(shown) + 1)))
        explained = [number for lines, _ in EXPLANATION.findall(TRACE)
                     for number in numbers(lines)]
        self.assertEqual(explained, shown)

    def test_each_rule_named_is_there(self):
        there = set(re.findall(r"^### (\d+\.\d+) ", PAGE, re.M))
        there |= set(re.findall(r"^\* \*\*(\d[a-z])\*\*", PAGE, re.M))
        for _, rules in EXPLANATION.findall(TRACE):
            for rule in rules.split(", "):
                self.assertIn(rule.split(" ")[0], there)


if __name__ == "__main__":
    unittest.main()
