"""Tests tools/run and tools/dependencies. The programs that they call are
replaced by ones that record the calls. Alone: python3 tests/tools/run_test.py"""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[2] / "tools"


class Scripts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top = Path(folder.name)
        for name in ("run", "dependencies"):
            (self.top / "tools").mkdir(exist_ok=True)
            shutil.copy(TOOLS / name, self.top / "tools" / name)

    def program(self, path, text):
        file = self.top / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("#!/bin/bash\n" + text)
        file.chmod(0o755)

    def start(self, *command, stdin=""):
        path = f"{self.top}/bin:{os.environ['PATH']}"
        return subprocess.run([self.top / command[0], *command[1:]],
                              env={**os.environ, "PATH": path}, input=stdin,
                              capture_output=True, text=True)


class Run(Scripts):
    def setUp(self):
        super().setUp()
        for step in ("dependencies", "build"):
            self.program(f"tools/{step}", f'echo {step} "$@"; cat; exit 0')
        self.program("build/release/bin/parlour",
                     'printf "<%s>" "$@"; cat; exit 7')

    def test_input_output_and_exit_code_are_the_programs_own(self):
        run = self.start("tools/run", "--", "--clock", "2026-11-21 09:00",
                         stdin="Hello.\n")
        self.assertEqual(
            "<run><receptionist><--clock><2026-11-21 09:00>Hello.\n",
            run.stdout)
        self.assertEqual("dependencies build\nbuild release parlour\n",
                         run.stderr)
        self.assertEqual(7, run.returncode)

    def test_no_argument_is_needed(self):
        self.assertEqual("<run><receptionist>", self.start("tools/run").stdout)

    def test_arguments_stand_after_two_dashes(self):
        run = self.start("tools/run", "--text")
        self.assertEqual((2, ""), (run.returncode, run.stdout))
        self.assertIn("usage", run.stderr)

    def test_a_failed_build_starts_nothing(self):
        self.program("tools/build", "exit 1")
        run = self.start("tools/run")
        self.assertEqual((1, ""), (run.returncode, run.stdout))


class Dependencies(Scripts):
    def setUp(self):
        super().setUp()
        for name in ("apt-get", "sudo"):
            self.program(f"bin/{name}", f'echo {name} "${{@: -1}}"')

    def packages(self, missing):
        self.program("bin/dpkg-query", f"""
            [[ "$*" == *' {missing}' ]] && echo not-installed || echo installed
            """)

    def test_nothing_is_done_when_all_is_there(self):
        self.packages(missing="nothing")
        run = self.start("tools/dependencies", "build", "test", "check")
        self.assertEqual((0, "", ""),
                         (run.returncode, run.stdout, run.stderr))

    def test_what_is_missing_is_installed(self):
        self.packages(missing="libedit-dev")
        run = self.start("tools/dependencies", "build")
        self.assertEqual((0, ""), (run.returncode, run.stdout))
        who = "sudo" if os.geteuid() else "apt-get"
        self.assertEqual(f"installing: libedit-dev\n{who} libedit-dev\n",
                         run.stderr)

    def test_a_section_is_installed_by_itself(self):
        self.packages(missing="libgtest-dev")
        self.assertEqual("",
                         self.start("tools/dependencies", "build").stderr)

    def test_a_failed_installation_is_told(self):
        self.packages(missing="libedit-dev")
        for name in ("apt-get", "sudo"):
            self.program(f"bin/{name}", "exit 100")
        self.assertNotEqual(0, self.start("tools/dependencies").returncode)


if __name__ == "__main__":
    unittest.main()
