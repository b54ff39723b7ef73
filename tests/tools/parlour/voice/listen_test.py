"""A shipped application hears with the recogniser that is installed, however
many words it has."""

import json
import pathlib
import subprocess
import unittest

from voice_case import PROGRAM, ProgramCase, WAIT

RECEPTIONIST = (pathlib.Path(__file__).resolve().parents[4]
                / "config/apps/receptionist")


class ListenTest(ProgramCase):

    def run_program(self, *arguments):
        return subprocess.run(
            [PROGRAM, *arguments], capture_output=True, text=True, check=True,
            timeout=WAIT).stdout

    def test_the_receptionist_hears_whom_a_visitor_wants(self):
        file = str(self.folder / "said.wav")
        self.run_program(
            "say", "I am here to meet Jeffery Ho.", "--component", "FliteTTS",
            "--voice", "rms", "-o", file)
        heard = self.run_program(
            "listen", str(RECEPTIONIST), file, "--json")
        self.assertIn("Jeffery Ho", json.dumps(json.loads(heard)))


if __name__ == "__main__":
    unittest.main()
