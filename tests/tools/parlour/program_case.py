"""ProgramCase: runs the built program in a temporary folder, and ends it with
the test."""

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
        """Creates or replaces a file in the folder."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        beside = path.with_name(path.name + "~")
        beside.write_text(text, encoding="utf-8")
        beside.rename(path)  # replace by renaming, as editors do
        return path

    def begin(self, *arguments, **options):
        """Starts the program; it is killed if it outlives the test."""
        running = subprocess.Popen([PROGRAM, *arguments], **options)
        self.addCleanup(running.wait)
        self.addCleanup(running.kill)
        for stream in (running.stdin, running.stdout, running.stderr):
            if stream:
                self.addCleanup(stream.close)
        return running
