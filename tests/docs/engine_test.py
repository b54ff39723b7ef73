#!/usr/bin/env python3
"""The trace that docs/engine.md explains is what the program prints."""

import re
import unittest

from page_case import PageCase, ROOT, blocks_of


class EngineTest(PageCase):
    def test_the_trace_is_the_one_that_the_program_prints(self):
        page = (ROOT / "docs" / "engine.md").read_text(encoding="utf-8")
        shown, command = [], ""
        for info, text in blocks_of(page):
            if info == "sh":
                command = text
            elif command:
                shown += re.findall(r"^ *\d+  (.*)$", text, re.M)
        printed = self.run_commands(
            f"cd '{ROOT}'\n{{\n{command}}} 2>&1 >/dev/null").splitlines()
        self.assertGreater(len(shown), 50)
        self.assertLessEqual(len(shown), len(printed))
        for expected, found in zip(shown, printed):
            pattern = re.escape(expected).replace("…", ".*")
            if not re.fullmatch(pattern, found.rstrip()):
                self.assertEqual(found, expected)


if __name__ == "__main__":
    unittest.main()
