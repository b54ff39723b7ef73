#!/usr/bin/env python3
"""docs/plugins.md does what it says, against an installed Parlour and outside of
its tree; what is installed needs nothing of CAF."""

import os
import shutil
import subprocess
import unittest
from pathlib import Path

from page_case import PROGRAM, PageCase, blocks_of, ROOT

BUILD = PROGRAM.resolve().parents[1]


@unittest.skipUnless((BUILD / "cmake_install.cmake").exists(), "nothing built")
class PluginsTest(PageCase):
    def setUp(self):
        super().setUp()
        self.prefix = Path(self.folder.name) / "prefix"
        subprocess.run(
            ["cmake", "--install", BUILD, "--component", "plugins",
             "--prefix", self.prefix], check=True, stdout=subprocess.DEVNULL)
        self.environment["CMAKE_PREFIX_PATH"] = str(self.prefix)
        if shutil.which("ninja"):
            self.environment["CMAKE_GENERATOR"] = "Ninja"

    @unittest.skipIf("LSAN_OPTIONS" in os.environ,
                     "its programs are built without a sanitizer")
    def test_the_page_does_what_it_says(self):
        self.assertGreater(self.try_out("plugins.md"), 3)

    def test_its_plugin_is_short(self):
        page = (ROOT / "docs" / "plugins.md").read_text(encoding="utf-8")
        lines = [line for info, text in blocks_of(page)
                 for line in text.splitlines() if info.startswith("cpp ")]
        self.assertGreater(len(lines), 20)
        self.assertLess(len(lines), 60)

    def test_the_installed_headers_need_nothing_of_ours_and_no_caf(self):
        include = self.prefix / "include" / "parlour"
        headers = sorted(file.relative_to(include)
                         for file in include.rglob("*.hpp"))
        self.assertGreater(len(headers), 20)
        source = self.work / "all.cpp"
        source.write_text(
            "".join(f'#include "{header}"\n' for header in headers) +
            "#ifdef CAF_VERSION\n#error a header includes CAF\n#endif\n",
            encoding="utf-8")
        done = subprocess.run(
            [os.environ.get("CXX", "c++"), "-std=c++20", "-fsyntax-only",
             "-Wall", "-Wextra", "-Werror", "-I", include, source],
            text=True, stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
