#!/usr/bin/env python3
"""docs/tutorial.md does what it says."""

import unittest

from page_case import PageCase


class TutorialTest(PageCase):
    def test_the_page_does_what_it_says(self):
        self.assertGreater(self.try_out("tutorial.md"), 7)


if __name__ == "__main__":
    unittest.main()
