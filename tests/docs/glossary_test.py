#!/usr/bin/env python3
"""The terms of docs/glossary.md are in order, and the types and files that it
and docs/architecture.md name are there."""

import re
import unittest

from page_case import ROOT

DOCS = ROOT / "docs"
GLOSSARY = (DOCS / "glossary.md").read_text(encoding="utf-8")
# | term | meaning |
ROWS = re.findall(r"^\| (?!term |---)([^|]+?) \| .* \|$", GLOSSARY, re.M)
# A type in backticks: `MessageBus`, not an element or an acronym.
TYPE = re.compile(r"`([A-Z][a-z]+(?:[A-Z][a-z]+)+|Box|Code|Host|Match|Port)`")


def declared_types():
    for top in ("runtime", "script", "actors", "adapters", "tools"):
        for header in (ROOT / top).rglob("*.hpp"):
            text = header.read_text(encoding="utf-8")
            yield from re.findall(r"^\s*(?:class|struct|enum class) (\w+)",
                                  text, re.M)


class GlossaryTest(unittest.TestCase):
    def test_terms_are_in_order_and_stand_once(self):
        self.assertGreater(len(ROWS), 100)
        self.assertEqual(ROWS, sorted(set(ROWS), key=str.lower))

    def test_types_that_are_named_are_declared(self):
        declared = set(declared_types())
        for page in ("glossary.md", "architecture.md"):
            named = TYPE.findall((DOCS / page).read_text(encoding="utf-8"))
            self.assertGreater(len(named), 3)
            for name in named:
                with self.subTest(page=page, name=name):
                    self.assertIn(name, declared)


if __name__ == "__main__":
    unittest.main()
