#!/usr/bin/env python3
"""The receptionist on a MariaDB server of the test's own: one name of its
settings changed, the same conversations. Skipped where there is no mariadbd."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
RECEPTIONIST = ROOT / "config/apps/receptionist"
PROGRAM = os.environ.get("PARLOUR_PROGRAM", "")
SERVER = shutil.which("mariadbd", path="/usr/sbin:/usr/libexec:/usr/bin")
# One that writes a visitor and a meeting, one that asks for facilities.
CONVERSATIONS = ("correction", "levels")


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
             "--innodb-use-native-aio=0"],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        cls.addClassCleanup(server.stdout.close)
        cls.addClassCleanup(server.wait)
        cls.addClassCleanup(server.kill)
        for line in server.stdout:
            if b"ready for connections" in line:
                return
        raise RuntimeError("mariadbd does not start")

    def setUp(self):
        self.assertTrue(os.path.exists(PROGRAM),
                        f"PARLOUR_PROGRAM names no program: '{PROGRAM}'")
        self.application = self.folder / self.id().rpartition(".")[2]
        shutil.copytree(RECEPTIONIST, self.application)
        settings = self.application / "settings.xml"
        settings.write_text(
            settings.read_text().replace("SQLiteDatabase", "MySQLDatabase"))
        for conversation in (self.application / "dialogues").glob("*.txt"):
            if conversation.stem not in CONVERSATIONS:
                conversation.unlink()

    def run_program(self, *arguments, given="", socket=None):
        environment = dict(os.environ,
                           MYSQL_UNIX_PORT=str(socket or self.socket))
        return subprocess.run([PROGRAM, *arguments], input=given, text=True,
                              env=environment, capture_output=True, timeout=120)

    def run_receptionist(self, given):
        data = self.application / "data"
        return self.run_program("run", str(self.application), "--text",
                                "--data", str(data), "--clock",
                                "2026-11-21 09:00", given=given)

    def test_holds_its_conversations(self):
        done = self.run_program("test", str(self.application))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(str(len(CONVERSATIONS)), done.stdout)

    def test_checks_without_a_server(self):
        done = self.run_program("check", str(self.application),
                                socket=self.folder / "nowhere")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("0 errors, 0 warnings", done.stdout + done.stderr)

    def test_keeps_what_it_was_told(self):
        asked = "where is the gym\n\n"
        first = self.run_receptionist(asked)
        self.assertIn("Skyline Gym", first.stdout, first.stderr)
        again = self.run_receptionist(asked)
        self.assertEqual(again.stdout, first.stdout, again.stderr)


if __name__ == "__main__":
    unittest.main()
