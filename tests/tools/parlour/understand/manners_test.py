#!/usr/bin/env python3
"""What people say means the same with a greeting or thanks as without: tried with
sentences of all applications that have wordings."""

import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import PROGRAM, ProgramCase  # noqa: E402

APPLICATIONS = pathlib.Path(__file__).parents[4] / "config" / "apps"
# Enough to see a rule go wrong, and few enough for each run of the tests.
SENTENCES = 80
MANNERS = ["Good morning, {}", "Okay, {}", "Excuse me, {}", "um {}",
           "{}, please", "{}, thank you"]
# A courtesy may be what a rule of the application is about.
MAY_DIFFER = 0.08


def sentences(application):
    lines = (application / "wordings.tsv").read_text(encoding="utf-8").splitlines()
    said = [re.sub(r"\[([^]]*)\]\(\w+\)", r"\1", line.split("\t")[1])
            for line in lines if "\t" in line and not line.startswith("#")]
    step = max(1, len(said) // SENTENCES)
    return [text.rstrip(" .!") for text in said[::step]]


def meaning(understood):
    return [(act.get("topic"), act["act"],
             {name: slot.get("value") for name, slot in act["slots"].items()})
            for act in understood["acts"]
            if act.get("topic") or act["act"] in ("deny", "cancel")]


class Manners(ProgramCase):

    def understand(self, application, texts):
        run = subprocess.run(
            [PROGRAM, "understand", str(application), "--batch",
             "--clock", "2026-11-21 09:00"],
            input="\n".join(texts) + "\n", capture_output=True, text=True,
            env={**os.environ, "HOME": str(self.folder)}, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        lines = run.stdout.splitlines()
        self.assertEqual(len(lines), len(texts))
        return [meaning(json.loads(line)) for line in lines]

    def understand_parts(self, application, texts, length):
        read = self.understand(application, texts)
        return [read[at:at + length] for at in range(0, len(read), length)]

    def test_courtesies_change_nothing(self):
        applications = sorted(path.parent
                              for path in APPLICATIONS.glob("*/wordings.tsv"))
        self.assertGreater(len(applications), 3)
        for application in applications:
            said = sentences(application)
            # All in one run: what is learnt is learnt once.
            polite = [manner.format(text) for manner in MANNERS for text in said]
            plain, *made = self.understand_parts(application, said + polite, len(said))
            for manner, read in zip(MANNERS, made):
                differ = [f"{manner.format(text)}: {one} instead of {other}"
                          for text, one, other in zip(said, read, plain)
                          if one != other]
                with self.subTest(application=application.name, manner=manner):
                    self.assertLessEqual(len(differ), MAY_DIFFER * len(said),
                                         "\n" + "\n".join(differ))


if __name__ == "__main__":
    unittest.main()
