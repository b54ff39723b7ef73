#!/usr/bin/env python3
"""Tests that docs/reference has the pages which the program prints."""

import re
import subprocess
import unittest

from page_case import PROGRAM, ROOT

FOLDER = ROOT / "docs" / "reference"
# The program's names for the pages.
PAGES = {"README.md": "index", "elements.md": "elements",
         "functions.md": "functions", "roles.md": "roles",
         "components.md": "components"}


@unittest.skipUnless(PROGRAM.exists(), "parlour is not built")
class ReferenceTest(unittest.TestCase):
    def test_each_page_is_what_the_program_prints(self):
        self.assertEqual({path.name for path in FOLDER.iterdir()}, set(PAGES))
        for name, page in PAGES.items():
            printed = subprocess.run(
                [PROGRAM, "help", "--page", page], capture_output=True,
                encoding="utf-8", check=True).stdout
            if (FOLDER / name).read_text(encoding="utf-8") != printed:
                self.fail(f"print it again: {PROGRAM} help --page {page} "
                          f"> {FOLDER / name}")

    def test_links_lead_somewhere(self):
        for name in PAGES:
            page = (FOLDER / name).read_text(encoding="utf-8")
            page = re.sub(r"^```.*?^```", "", page, flags=re.M | re.S)
            for target, anchor in re.findall(
                    r"\]\(([^)#]+)(?:#([^)]*))?\)", page):
                self.assertTrue((FOLDER / target).exists(), target)
                if anchor:
                    self.assertIn(anchor, self.anchors(target), name)

    def anchors(self, name):
        text = (FOLDER / name).read_text(encoding="utf-8")
        found = [re.sub(r"[^\w -]", "", line.lower()).replace(" ", "-")
                 for line in re.findall(r"^#+ (.*)$", text, re.M)]
        self.assertEqual(len(found), len(set(found)), "two headings are equal")
        return found


if __name__ == "__main__":
    unittest.main()
