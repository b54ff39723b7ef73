#!/usr/bin/env python3
"""Tests that each line of docs/comparison.md names plays that exist and whose
scripts have what it speaks of, or says that it is lacking."""

import re
import unittest

from page_case import ROOT

PAGE = ROOT / "docs" / "comparison.md"
PLAYS = ROOT / "tests" / "script" / "dialogue" / "plays"


def rows():
    """(there, here, plays) of each line."""
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split(" | ")]
        if line.startswith("| ") and cells[0] not in ("there", "---"):
            cells[-1] = cells[-1].strip("| ")
            yield cells[0], cells[1], re.findall(r"`(\w+)`", cells[-1])


class Comparison(unittest.TestCase):
    def test_each_line_has_a_play_or_is_lacking(self):
        found = list(rows())
        self.assertGreater(len(found), 50)
        for there, here, plays in found:
            self.assertEqual(here.startswith("lacking"), not plays, there)
            for play in plays:
                self.assertTrue((PLAYS / f"{play}.xml").exists(),
                                f"{there}: {play}")

    def test_attributes_are_shown_by_one_of_the_plays(self):
        for there, here, plays in rows():
            scripts = " ".join((PLAYS / f"{play}.xml").read_text(
                encoding="utf-8") for play in plays)
            for attribute in re.findall(r'`(\w+="\w+")`', here):
                with self.subTest(line=there, attribute=attribute):
                    if plays and attribute.split("=")[0] in (
                            "many", "commit", "part"):
                        self.assertIn(attribute, scripts)


if __name__ == "__main__":
    unittest.main()
