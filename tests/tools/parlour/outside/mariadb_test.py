#!/usr/bin/env python3
"""Runs the applications' conversations on a MariaDB server, with only the
database's name changed in the settings. Skipped if mariadbd is missing."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[4]
RECEPTIONIST = ROOT / "config/apps/receptionist"
LEDGER = ROOT / "tests/tools/parlour/applications/ledger"
PROGRAM = os.environ.get("PARLOUR_PROGRAM", "")
SERVER = shutil.which("mariadbd", path="/usr/sbin:/usr/libexec:/usr/bin")


@unittest.skipUnless(SERVER, "there is no mariadbd; mariadb-server-core has it")
class OnMariaDB(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        (cls.folder / "server").mkdir()
        cls.socket = cls.folder / "socket"
        server = subprocess.Popen(
            [SERVER, "--no-defaults", "--user=root", "--skip-networking",
             f"--datadir={cls.folder / 'server'}", f"--socket={cls.socket}",
             f"--pid-file={cls.folder / 'pid'}", "--skip-grant-tables",
             "--innodb-buffer-pool-size=8M", "--innodb-log-file-size=4M",
             "--innodb-flush-log-at-trx-commit=2", "--performance-schema=OFF",
             "--innodb-use-native-aio=0", "--innodb-flush-method=nosync",
             "--sync-frm=0", "--log-warnings=0"],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        cls.addClassCleanup(server.stdout.close)
        cls.addClassCleanup(server.wait)
        cls.addClassCleanup(server.kill)
        if not any(b"ready for connections" in line for line in server.stdout):
            raise RuntimeError("mariadbd does not start")

    def setUp(self):
        self.assertTrue(os.path.exists(PROGRAM),
                        f"PARLOUR_PROGRAM names no program: '{PROGRAM}'")

    def on_mariadb(self, application):
        """A copy of it, with the one name changed."""
        copy = self.folder / self.id().rpartition(".")[2]
        shutil.copytree(application, copy)
        settings = copy / "settings.xml"
        text = settings.read_text(encoding="utf-8")
        self.assertIn("SQLiteDatabase", text)
        settings.write_text(text.replace("SQLiteDatabase", "MySQLDatabase"),
                            encoding="utf-8")
        return copy

    def run_program(self, *arguments, given="", socket=None):
        environment = dict(os.environ,
                           MYSQL_UNIX_PORT=str(socket or self.socket))
        return subprocess.run([PROGRAM, *arguments], input=given,
                              encoding="utf-8",
                              env=environment, capture_output=True, timeout=400)

    def run_text(self, application, given):
        return self.run_program("run", str(application), "--text",
                                "--data", str(application / "data"),
                                "--clock", "2026-11-21 09:00", given=given)

    def expect_conversations(self, application):
        count = len(list((application / "dialogues").glob("*.txt")))
        done = self.run_program("test", str(application))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(f"{count} of {count} conversations passed", done.stdout)

    def test_scripts_find_one_behaviour(self):
        self.expect_conversations(LEDGER)
        self.expect_conversations(self.on_mariadb(LEDGER))

    def test_the_receptionist_holds_its_conversations(self):
        self.expect_conversations(self.on_mariadb(RECEPTIONIST))

    def test_checks_without_a_server(self):
        done = self.run_program("check", str(self.on_mariadb(RECEPTIONIST)),
                                socket=self.folder / "nowhere")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("0 errors, 0 warnings", done.stdout + done.stderr)

    def test_keeps_what_it_was_told(self):
        application = self.on_mariadb(LEDGER)
        self.run_text(application, "open Zoë\npay\n\n")
        again = self.run_text(application, "all\n\n")
        self.assertIn("Ann 6 Ben 24 Zoë 0", again.stdout, again.stderr)


if __name__ == "__main__":
    unittest.main()
