#!/usr/bin/env python3
"""Tests the steps of docs/tutorial.md."""

import unittest

from page_case import PageCase


class TutorialTest(PageCase):
    def test_the_page_does_what_it_says(self):
        self.assertGreater(self.try_out("tutorial.md"), 7)


if __name__ == "__main__":
    unittest.main()
