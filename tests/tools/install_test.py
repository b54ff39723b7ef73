#!/usr/bin/env python3
"""Tests tools/install: the installed program works from any folder without the
source tree, and --remove deletes exactly what was installed."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get(
    "PARLOUR_PROGRAM", ROOT / "build" / "debug" / "bin" / "parlour"))
BUILD = PROGRAM.resolve().parents[1]


@unittest.skipUnless((BUILD / "cmake_install.cmake").exists(), "nothing built")
class Install(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.prefix = Path(folder.name) / "Präfix mit Lücke"
        self.environment = {"HOME": folder.name, "PATH": os.environ["PATH"],
                            "PARLOUR_BUILD": str(BUILD)}

    def call(self, *command, status=0):
        done = subprocess.run(
            command, cwd="/", env=self.environment, encoding="utf-8",
            stdin=subprocess.DEVNULL, capture_output=True, timeout=240,
            check=False)
        self.assertEqual(done.returncode, status, done)
        return done.stdout + done.stderr

    def install(self, *arguments, status=0):
        return self.call(ROOT / "tools" / "install", *arguments, status=status)

    def parlour(self, *arguments, status=0):
        return self.call(self.prefix / "bin" / "parlour", *arguments,
                         status=status)

    def files(self):
        return {str(path.relative_to(self.prefix))
                for path in self.prefix.rglob("*") if not path.is_dir()}

    def test_what_is_installed_works_and_goes_again(self):
        said = self.install(self.prefix)
        self.assertIn(f"export PATH=\"{self.prefix}/bin:$PATH\"", said)
        self.assertIn("Away with it: tools/install --remove ", said)
        self.finds_what_came_with_it()
        self.brings_what_plugins_and_shells_want()
        self.is_replaced()
        self.leaves_what_it_has_not_brought()

    def finds_what_came_with_it(self):
        self.assertNotIn(str(ROOT), self.parlour("check", "nobody", status=2))
        script = self.prefix / "share/parlour/apps/lab/lab.xml"
        words = "Welcome to the robot lab. What would you like?"
        text = script.read_text(encoding="utf-8")
        self.assertIn(words, text)
        script.write_text(text.replace(words, "Here I am."), encoding="utf-8")
        self.assertEqual(self.parlour("run", "lab"), "Here I am.\n")

    def brings_what_plugins_and_shells_want(self):
        for name in ("include/parlour/runtime/plugin/adaptors.hpp",
                     "lib/cmake/Parlour/ParlourConfig.cmake",
                     "lib/libparlour.so"):
            self.assertTrue((self.prefix / name).exists(), name)
        completion = self.prefix / "share/bash-completion/completions/parlour"
        self.assertIn("parlour", self.call(
            "bash", "-c", 'source "$0" && complete -p parlour', completion))

    def is_replaced(self):
        before = self.files()
        old = self.prefix / "share/parlour/apps/old.xml"
        old.touch()
        listed = self.prefix / "lib/parlour/installed.txt"
        listed.write_text(listed.read_text("utf-8") +
                          "share/parlour/apps/old.xml\n", encoding="utf-8")
        self.install(self.prefix)
        self.assertEqual(self.files(), before)
        self.assertIn("Welcome", self.parlour("run", "lab"))

    def leaves_what_it_has_not_brought(self):
        data = self.prefix / "share/parlour/lab/lab.db"
        data.parent.mkdir()
        data.touch()
        (self.prefix / "bin/other").touch()
        self.install("--remove", self.prefix)
        self.assertEqual(self.files(), {"share/parlour/lab/lab.db",
                                        "bin/other"})
        self.assertFalse((self.prefix / "include/parlour").exists())
        self.install("--remove", self.prefix, status=1)

    def test_without_root_it_goes_to_the_home_folder(self):
        somebody = {"user": "nobody"} if os.geteuid() == 0 else {}
        try:
            done = subprocess.run(
                [ROOT / "tools" / "install", "--remove"], cwd="/", check=False,
                env=self.environment, capture_output=True, encoding="utf-8",
                **somebody)
        except PermissionError:
            self.skipTest("the source is where nobody else may go")
        home = self.environment["HOME"]
        self.assertEqual((done.returncode, done.stderr), (
            1, f"tools/install has installed nothing in {home}/.local\n"))

    def test_mistakes_are_told_before_anything_is_built(self):
        self.environment["PARLOUR_BUILD"] = "/nowhere"
        for arguments in (("--help",), ("a", "b"), ("",), ("--remove", "")):
            self.assertIn("usage", self.install(*arguments, status=2))
        self.prefix.touch()
        self.assertIn("Not a directory", self.install(self.prefix, status=1))


if __name__ == "__main__":
    unittest.main()
