"""What tests of the program share: the program, a folder of the test's own, and
programs that end with the test."""

import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("PARLOUR_PROGRAM", "")


class ProgramCase(unittest.TestCase):

    def setUp(self):
        self.assertTrue(os.path.exists(PROGRAM),
                        f"PARLOUR_PROGRAM names no program: '{PROGRAM}'")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        """A file of the folder, new or in the place of what was there."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        beside = path.with_name(path.name + "~")
        beside.write_text(text, encoding="utf-8")
        beside.rename(path)  # as editors do
        return path

    def begin(self, *arguments, **options):
        """Runs the program, which is killed if it outlives the test."""
        running = subprocess.Popen([PROGRAM, *arguments], **options)
        self.addCleanup(running.wait)
        self.addCleanup(running.kill)
        for stream in (running.stdin, running.stdout, running.stderr):
            if stream:
                self.addCleanup(stream.close)
        return running
