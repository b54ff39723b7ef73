#!/usr/bin/env python3
"""Tests docs/repair.md: its <repair> elements are those of the play
docs_of_repair, `parlour test` accepts its conversation's lines, and its table
lists every act of config/platform/repair.xml."""

import re
import unittest
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[2]
PLAYS = ROOT / "tests" / "script" / "dialogue" / "plays"
PLATFORM = ROOT / "config" / "platform"


def plain(text):
    """Without comments and white space."""
    return re.sub(r"\s+", "", re.sub(r"<!--.*?-->", "", text, flags=re.S))


class RepairTest(unittest.TestCase):
    page = (ROOT / "docs" / "repair.md").read_text(encoding="utf-8")

    def test_every_example_stands_in_the_play(self):
        play = plain((PLAYS / "docs_of_repair.xml").read_text("utf-8"))
        listing = re.search(r"^```xml\n(.*?)^```$", self.page, re.M | re.S)[1]
        examples = re.findall(r"<repair .*?</repair>", listing, re.S)
        self.assertGreater(len(examples), 5)
        for example in examples:
            with self.subTest(example.splitlines()[0]):
                self.assertIn(plain(example), play)

    def test_every_act_of_the_platform_is_told_of(self):
        repairs = (PLATFORM / "repair.xml").read_text(encoding="utf-8")
        for acts in re.findall(r'<repair act="([^"]*)"', repairs):
            for act in acts.split(","):
                self.assertIn(f"`{act.strip()}`", self.page)

    def test_every_pattern_is_held_in_two_applications(self):
        applications = ROOT / "config" / "apps"
        patterns = Counter(path.name for path in
                           applications.glob("*/dialogues/repair-*.txt"))
        self.assertGreater(len(patterns), 14)
        for pattern, times in patterns.items():
            with self.subTest(pattern):
                self.assertGreaterEqual(times, 2)


if __name__ == "__main__":
    unittest.main()
