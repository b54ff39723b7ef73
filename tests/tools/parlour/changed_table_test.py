#!/usr/bin/env python3
"""Tests that a running conversation understands what another program writes to
its database, without a restart (engine rule 1.9)."""

import pathlib
import shutil
import sqlite3
import subprocess
import unittest

from program_case import ProgramCase

NEWCOMERS = pathlib.Path(__file__).parent / "applications" / "newcomers"


class ChangedTable(ProgramCase):

    def setUp(self):
        super().setUp()
        shutil.copytree(NEWCOMERS, self.folder / "newcomers")
        self.running = self.begin(
            "run", str(self.folder / "newcomers"), "--data",
            str(self.folder / "data"), "--text", "--trace",
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, encoding="utf-8")
        self.until("Hello.")

    def until(self, *words):
        """Reads on until a line has some of these words, and returns them."""
        lines = []
        while True:
            line = self.running.stdout.readline()
            self.assertTrue(line, (words, lines))
            lines.append(line)
            for some in words:
                if some in line:
                    return some

    def say(self, line):
        self.running.stdin.write(line + "\n\n")
        self.running.stdin.flush()

    def say_until(self, answer, other):
        """The new values are told to the understanding, which needs a moment
        to take them in."""
        said = other
        while said != answer:
            self.say("call Deborah Winter")
            said = self.until(answer, other)

    def write_as_another_program(self, sql):
        with sqlite3.connect(self.folder / "data" / "newcomers.db") as other:
            other.execute(sql)
        other.close()

    def test_understands_what_another_program_adds_and_deletes(self):
        known = "I call Deborah Winter."
        unknown = "Deborah Winter is not possible here."
        self.say("call Deborah Winter")
        self.until(unknown)
        self.write_as_another_program(
            "insert into staff values ('Deborah Winter')")
        self.until("SetValues(db:staff.name")
        self.say_until(known, unknown)
        self.write_as_another_program(
            "delete from staff where name = 'Deborah Winter'")
        self.until("SetValues(db:staff.name")
        self.say_until(unknown, known)

    def test_keeps_the_old_values_of_a_table_that_is_gone(self):
        self.write_as_another_program("drop table staff")
        self.until("cannot be read, so its values stay")
        self.say("call Jeffery Ho")
        self.until("I call Jeffery Ho.")


if __name__ == "__main__":
    unittest.main()
