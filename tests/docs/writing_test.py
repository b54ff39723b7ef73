#!/usr/bin/env python3
"""Tests that the listings of docs/writing.md are those of its application."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).parents[2]
APPLICATION = ROOT / "config" / "apps" / "lab"


def collapsed(text):
    """Without white space: the page may break lines elsewhere."""
    return re.sub(r"\s+", "", text)


class WritingTest(unittest.TestCase):
    def test_every_listing_is_a_part_of_the_application(self):
        page = (ROOT / "docs" / "writing.md").read_text(encoding="utf-8")
        sources = [collapsed(path.read_text(encoding="utf-8"))
                   for path in APPLICATION.rglob("*")
                   if path.suffix in (".xml", ".txt")]
        blocks = re.findall(r"^```(\w*)\n(.*?)^```$", page, re.M | re.S)
        listings = [text for language, text in blocks if language != "sh"]
        self.assertGreater(len(listings), 5)
        for listing in listings:
            with self.subTest(listing.splitlines()[0]):
                self.assertTrue(any(collapsed(listing) in source
                                    for source in sources))


if __name__ == "__main__":
    unittest.main()
