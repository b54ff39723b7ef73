#!/usr/bin/env python3
"""Tests `parlour run` with invalid input, closed streams, signals and damaged
files: it answers or ends in order, and the database stays intact."""

import fcntl
import os
import pathlib
import select
import shutil
import signal
import sqlite3
import subprocess
import unittest

from program_case import PROGRAM, ProgramCase

ROOT = pathlib.Path(__file__).resolve().parents[3]
RECEPTIONIST = ROOT / "config/apps/receptionist"
GREETING = b"Good morning, how can I help you?\n"
GYM = b"There is one gym named Skyline Gym on the twenty third floor.\n"
LOST = b"Sorry. I do not fully understand your talk...\n"
ASK_GYM = b"where is the gym\n"
APPOINTMENT = b"I am David from Comptec to meet Dr. Jeffery Ho\n"


class Hostile(ProgramCase):

    def setUp(self):
        super().setUp()
        self.data = self.folder / "data"

    def arguments(self, application=RECEPTIONIST):
        return ["run", str(application), "--text", "--data", str(self.data),
                "--clock", "2026-11-21 09:00"]

    def run_with(self, given, application=RECEPTIONIST):
        return subprocess.run([PROGRAM, *self.arguments(application)],
                              input=given, capture_output=True, timeout=120)

    def said(self, given):
        ended = self.run_with(given)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertTrue(ended.stdout.startswith(GREETING), ended.stdout)
        return ended.stdout[len(GREETING):]

    def start(self):
        """A conversation in which the appointment's time was asked for."""
        running = self.begin(*self.arguments(), stdin=subprocess.PIPE,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(running.stdout.readline(), GREETING)
        running.stdin.write(APPOINTMENT + b"\n")
        running.stdin.flush()
        self.assertIn(b"time of your appointment", running.stdout.readline())
        return running

    def visitors(self):
        with sqlite3.connect(self.data / "receptionist.db") as database:
            self.assertEqual(
                database.execute("pragma integrity_check").fetchall(),
                [("ok",)])
            return [row[0] for row in database.execute(
                "select name from rr_visitor order by visitor_id")]

    def still_usable(self):
        self.assertIn(b"I will call Dr. Jeffery Ho",
                      self.said(b"I am Ann to meet Jeffery Ho at 10:30\n"))
        self.assertEqual(self.visitors()[-1], "Ann")


class Input(Hostile):

    def test_nothing(self):
        self.assertEqual(self.said(b""), b"")

    def test_empty_lines(self):
        self.assertEqual(self.said(b"\n" * 1000), b"")

    def test_no_newline_at_the_end(self):
        self.assertEqual(self.said(ASK_GYM[:-1]), GYM)

    def test_line_ends_of_other_systems(self):
        self.assertEqual(self.said(b"where is the gym\r\n\r\nbye\r\n"),
                         GYM + b"Goodbye, have a nice day!\n")

    def test_bytes_that_are_no_text(self):
        self.assertEqual(self.said(b"\xff\xfe\x00\n\n\xc3\x28\n" + ASK_GYM),
                         LOST + LOST + GYM)

    def test_100_000_characters(self):
        for given in (b"x", b"1", b"and ", b"meet Jeffery Ho at 10:30 by taxi "):
            with self.subTest(given):
                line = (given * 100_000)[:100_000] + b"\n"
                self.assertTrue(self.said(line + ASK_GYM).endswith(GYM))

    def test_more_than_a_line_may_have(self):
        ended = self.run_with(b"a" * 3_000_000)
        self.assertEqual(ended.returncode, 0)
        self.assertEqual(ended.stdout, GREETING + LOST)
        self.assertIn(b"the rest is left out", ended.stderr)

    def test_names_that_are_sql_or_script(self):
        self.said(b"I am Robert'--drop table rr_visitor from {date()} to "
                  b"meet Jeffery Ho at 10:30\n")
        self.assertIn("drop table rr_visitor", self.visitors()[-1])
        self.still_usable()


class Streams(Hostile):

    def shell(self, redirection, given=APPOINTMENT):
        line = '"$@" ' + redirection
        return subprocess.run(["sh", "-c", line, "sh", PROGRAM,
                               *self.arguments()],
                              input=given, capture_output=True, timeout=60)

    def test_output_that_nobody_reads(self):
        running = self.start()
        running.stdout.close()
        try:
            running.stdin.write(ASK_GYM * 3)
            running.stdin.close()
        except BrokenPipeError:
            pass
        self.assertEqual(141, running.wait(60))
        self.assertEqual([], self.told(running.stderr.read()))
        self.still_usable()

    # The database may answer when nobody is there any more: that is told, too.
    def told(self, errors):
        return [line for line in errors.decode().splitlines()
                if "its session is over" not in line]

    def refuses(self, redirection, reason):
        ended = self.shell(redirection)
        self.assertEqual((ended.returncode, self.told(ended.stderr)), (
            1, [f"error: what is printed cannot be written: {reason}"]))
        self.still_usable()

    def test_output_that_is_full(self):
        self.refuses(">/dev/full", "No space left on device")

    def test_output_that_is_closed(self):
        self.refuses(">&-", "Bad file descriptor")

    def test_input_that_is_closed(self):
        ended = self.shell("<&-")
        self.assertEqual((ended.returncode, ended.stdout), (0, GREETING))

    def test_input_without_a_pause(self):
        ended = self.run_with(b"x\n" * 1001)
        self.assertEqual(ended.returncode, 0)
        self.assertIn(b"taken in parts", ended.stderr)

    def test_a_reader_that_has_stopped(self):
        running = self.start()
        given = running.stdin.fileno()
        fcntl.fcntl(running.stdout, fcntl.F_SETPIPE_SZ, 4096)
        os.set_blocking(given, False)
        while select.select([], [given], [], 2)[1]:  # until it reads no more
            os.write(given, ASK_GYM * 100 + b"\n")
        running.send_signal(signal.SIGINT)
        self.assertEqual(running.wait(60), 130)


class Signals(Hostile):

    def test_ends_sessions_first(self):
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 0),
                               (signal.SIGHUP, 0)):
            with self.subTest(number):
                running = self.start()
                running.send_signal(number)
                self.assertEqual(running.wait(60), status)
                self.still_usable()

    def test_ends_at_once_at_the_second(self):
        running = self.start()
        running.send_signal(signal.SIGINT)
        running.send_signal(signal.SIGTERM)
        self.assertIn(running.wait(60), (130, -signal.SIGTERM))
        self.still_usable()

    def test_where_there_is_nothing_to_end(self):
        script = self.write("wait.xml", """<dialogue><function name="main">
            <log param="begun"/><wait for="10m"/></function></dialogue>""")
        for number, status in ((signal.SIGINT, 130),
                               (signal.SIGTERM, -signal.SIGTERM),
                               (signal.SIGHUP, -signal.SIGHUP)):
            with self.subTest(number):
                waiting = self.begin("exec", script, stderr=subprocess.PIPE)
                self.assertEqual(waiting.stderr.readline(), b"begun\n")
                waiting.send_signal(number)
                self.assertEqual(waiting.wait(60), status)

    def test_killed_in_the_middle(self):
        running = self.start()
        running.kill()
        running.wait(60)
        self.still_usable()


class Files(Hostile):

    def refused(self, name):
        ended = self.run_with(APPOINTMENT)
        self.assertEqual((ended.returncode, ended.stdout), (1, b""))
        self.assertIn(name.encode(), ended.stderr)

    def database(self):
        self.data.mkdir(exist_ok=True)
        return self.data / "receptionist.db"

    def test_a_second_process(self):
        self.start()
        self.refused("in use by another parlour")

    def test_a_file_for_the_folder(self):
        self.data.write_text("")
        self.refused(str(self.data))

    def test_a_database_that_is_none(self):
        self.database().write_bytes(b"garbage" * 5000)
        self.refused("receptionist.db")

    def test_a_folder_for_the_database(self):
        self.database().mkdir()
        self.refused("receptionist.db")

    def test_a_database_cut_short(self):
        self.said(b"")
        os.truncate(self.database(), 60_000)
        self.refused("receptionist.db")

    def test_a_database_without_its_tables(self):
        sqlite3.connect(self.database()).execute("create table t (x)")
        self.refused("receptionist.db")

    def test_one_error_for_a_broken_database(self):
        self.database().write_bytes(b"garbage" * 5000)
        errors = self.run_with(b"").stderr.decode().strip().split("\n")
        self.assertEqual(len(errors), 1, errors)
        self.assertIn("SQLiteDatabase", errors[0])
        self.assertIn("receptionist.db", errors[0])
        self.assertIn("move it away", errors[0])

    def test_one_error_for_a_database_of_something_else(self):
        sqlite3.connect(self.database()).execute("create table t (x)")
        errors = self.run_with(b"").stderr.decode().strip().split("\n")
        self.assertEqual(len(errors), 1, errors)
        self.assertIn("receptionist.db", errors[0])
        self.assertIn("move it away", errors[0])

    def test_a_database_that_another_holds(self):
        self.said(b"")
        other = sqlite3.connect(self.database())
        self.addCleanup(other.close)
        other.execute("begin immediate")
        self.assertIn(GYM, self.said(APPOINTMENT + b"10:30\n\n" + ASK_GYM))


class BrokenCopies(Hostile):

    def copy(self, *changes):
        application = self.data.parent / "receptionist"
        shutil.rmtree(application, ignore_errors=True)
        shutil.copytree(RECEPTIONIST, application)
        for name, old, new in changes:
            file = application / name
            text = file.read_text()
            self.assertIn(old, text)
            file.write_text(text.replace(old, new, 1))
        return application

    def findings(self, application):
        ended = subprocess.run([PROGRAM, "check", str(application)],
                               capture_output=True, timeout=60, text=True)
        self.assertEqual(ended.returncode, 1)
        started = self.run_with(b"hello\n", application)
        self.assertEqual((started.returncode, started.stdout), (1, b""))
        self.assertFalse(self.data.exists())
        # The source's line, and the mark under it, are set in.
        return [line.replace(str(application) + "/", "")
                for line in ended.stdout.splitlines()
                if not line.startswith(" ")]

    def expect(self, found, *places):
        self.assertEqual([line.split(": ")[0] for line in found], list(places),
                         found)

    def test_every_finding_at_its_place(self):
        application = self.copy(
            ("receptionist.xml", "topics/general.xml", "topics/generel.xml"),
            ("receptionist.xml", "<speak", "<speek"),
            ("settings.xml", 'start="Welcome"', 'start="Welcom"'),
            ("settings.xml", "LogTaxi", "LogTaxy"),
            ("settings.xml", 'option name="reports"', 'option name="report"'),
            ("topics/taxi.xml", 'this.Time ge time()"', 'this.Time ge time("'))
        places = (("receptionist.xml", "topics/generel.xml", 18),
                  ("receptionist.xml", "<speek", 7),
                  ("settings.xml", 'start="Welcom"', 38),
                  ("settings.xml", "LogTaxy", 5),
                  ("settings.xml", "<Plugin>LogWeather", 5),
                  ("settings.xml", '<option name="report"', 5),
                  ("topics/taxi.xml", 'this.Time ge time("', 40))
        self.expect(self.findings(application), *(
            f"{name}:{self.line_of(application / name, text)}:{column}"
            for name, text, column in places))

    def line_of(self, file, text):
        before, found, _ = file.read_text().partition(text)
        self.assertTrue(found)
        return before.count("\n") + 1

    def test_grammar(self):
        grammar = "grammars/receptionist.jsgf"
        application = self.copy((grammar, "grammar receptionist;",
                                 "grammar receptionist;\n"
                                 "public <broken> = is <no_rule> there;"))
        line = self.line_of(application / grammar, "<no_rule>")
        found = self.findings(application)
        self.assertEqual(len(found), 1)
        self.assertIn(f"{grammar}:{line}:", found[0])

    def test_column_that_is_not_there(self):
        grammar = "grammars/receptionist.jsgf"
        application = self.copy((grammar, "rr_staff.staff_name",
                                 "rr_staff.name"))
        line = self.line_of(application / grammar, "rr_staff.name")
        self.assertIn(f"{grammar}:{line}:", self.findings(application)[0])

    def test_files_that_are_not_there(self):
        for name in ("sql/schema.sql", "sql/seed.sql", "topics/taxi.xml",
                     "grammars/receptionist.jsgf", "settings.xml"):
            with self.subTest(name):
                application = self.copy()
                (application / name).unlink()
                self.assertTrue(any(
                    name in one for one in self.findings(application)))


if __name__ == "__main__":
    unittest.main()
