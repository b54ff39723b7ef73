#!/usr/bin/env python3
"""Tests every command with wrong arguments and in bad conditions: each ends with
the right status and a line that says why. Nothing is lost, crashes or hangs."""

import os
import re
import resource
import shutil
import socket
import subprocess
import unittest

from program_case import PROGRAM, ProgramCase

SCRIPT = """<dialogue>
  <state name="Hello"><Entrance><speak param="Hello."/></Entrance></state>
  <function name="main"><print param="done"/></function>
</dialogue>
"""
PIPE = "this is a named pipe, not a file"
FOLDER = "this is a folder, not a file"
LOOP = "Too many levels of symbolic links"
NOWHERE = "No such file or directory"

# One way to print something with each command that prints.
PRINTING = (
    ("--help",), ("--version",), ("check", "broken"), ("completion", "bash"),
    ("exec", "app"), ("format", "-"), ("help", "speak"),
    ("keygen", "robot.key"), ("plugin", "list"),
    ("plugin", "new", "EchoTTS", "--role", "TTS"), ("plugin", "roles"),
    ("plugin", "test", "LogTaxi"), ("run", "app"),
    ("say", "hello", "-o", "said.wav"), ("schema",),
    ("test", "app"), ("understand", "app", "hello"))
# A program of its own, one that waits for a platform, those that ask what runs,
# one that depends on the machine's sound card (devices_test.py), one that hears
# (speech_commands_test.py), those that need a journal (replay_test.py), one that
# needs a server, and one that ends when it is told to (serve_test.py).
NOT_TRIED = {"agent", "bench", "devices", "journal", "listen", "load", "reload",
             "replay", "serve", "status", "tail", "tap", "top"}

# Arguments, status, and what is said about it.
MISTAKES = (
    ((), 2, "a command is missing"),
    (("chek",), 2, "no command 'chek', did you mean 'check'"),
    (("--verson",), 2, "no option '--verson', did you mean '--version'"),
    (("run",), 2, "APP is required"),
    (("run", "app", "app"), 2, "not expected: app"),
    (("run", "app", "--nothing"), 2, "not expected: --nothing"),
    (("run", ""), 2, "there is no application ''"),
    (("run", "nobody"), 2, "there is no application 'nobody': looked for"),
    (("run", "file"), 2, "'file' is no folder, and an application is"),
    (("run", "pipe"), 2, "'pipe' is no folder, and an application is"),
    (("run", "loop"), 2, "cannot be read: " + LOOP),
    (("run", "x" * 300), 2, "cannot be read: File name too long"),
    (("run", "empty"), 1, "neither settings.xml nor a script"),
    (("run", "app", "--seed", "-1"), 2, "'-1' is no whole number from 0"),
    (("run", "app", "--seed=-1"), 2, "'-1' is no whole number from 0"),
    (("run", "app", "--seed", ""), 2, "'' is no whole number"),
    (("run", "app", "--seed", "0x10"), 2, "'0x10' is no whole number"),
    (("run", "app", "--seed", "1.5"), 2, "'1.5' is no whole number"),
    (("run", "app", "--seed", "18446744073709551616"), 2, "no whole number"),
    (("run", "app", "--seed"), 2, "--seed: 1 required"),
    (("run", "app", "--seed", "1", "--seed", "2"), 2, "--seed: At Most 1"),
    (("run", "app", "--clock", "2026-02-30 09:00"), 2, "is no time"),
    (("run", "app", "--clock", "2026-11-21 09:00:61"), 2, "is no time"),
    (("run", "app", "--data", ""), 2, "--data: an empty name"),
    (("run", "app", "--data", "file"), 1, "cannot be made: Not a directory"),
    (("run", "app", "--data", "loop"), 1, "cannot be made: " + LOOP),
    (("run", "app", "--plugins", ""), 2, "--plugins: an empty name"),
    (("run", "app", "--plugins", "none"), 2, "there is no folder 'none'"),
    (("run", "app", "--plugins", "file"), 2, "cannot be read: Not a dir"),
    (("run", "app", "--speaker", "x.wav"), 2, "--speaker requires --voice"),
    (("run", "app", "--push-to-talk"), 2, "--push-to-talk requires --voice"),
    (("run", "app", "--voice", "--talk-key", "f5"), 2,
     "--talk-key requires --push-to-talk"),
    (("run", "app", "--journal", ""), 2, "--journal: an empty name"),
    (("run", "app", "--journal", "file"), 1,
     "folder cannot be opened: Not a directory"),
    (("run", "app", "--journal", "pipe"), 1,
     "folder cannot be opened: Not a directory"),
    (("replay", "app"), 2, "JOURNAL is required"),
    (("journal", "list", "nothing"), 2, "nothing: this folder cannot be read"),
    (("journal", "export", "app"), 2, "JOURNAL is required"),
    (("journal", "export", "app", ".", "--as", "x"), 2, "--as"),
    (("replay", "app", "nothing"), 2, "nothing: this folder cannot be read"),
    (("replay", "app", "file"), 2, "file: this folder cannot be read"),
    (("check", "file"), 1, "file:1:1: error: there is no element"),
    (("check", "pipe"), 1, "pipe: error: " + PIPE),
    (("check", "loop"), 1, "loop: error: this file cannot be read: " + LOOP),
    (("check", "script-is-pipe"), 1, "/x.xml: error: " + PIPE),
    (("check", "script-is-socket"), 1, "/x.xml: error: this is a socket"),
    (("check", "script-is-folder"), 1, "/x.xml: error: " + FOLDER),
    (("check", "script-is-loop"), 1, "/x.xml: error: this file cannot be read: "
     + LOOP),
    (("check", "script-is-huge"), 1, "/x.xml: error: this file is larger than"),
    (("check", "script-is-binary"), 1, "/x.xml:1:1: error: this is not UTF-8"),
    (("check", "settings-are-pipe"), 1, "settings.xml: error: " + PIPE),
    (("check", "settings-are-nowhere"), 1, "settings.xml: error: this file "
     "cannot be read: " + NOWHERE),
    (("check", "sql-is-pipe"), 1, "/x.sql: error: " + PIPE),
    (("devices", "--seconds", "0"), 2, "'0' is no whole number from 1 to 600"),
    (("devices", "--test", "--microphone", ""), 2, "an empty name"),
    (("devices", "--speaker", "x"), 2, "--speaker requires --test"),
    (("say",), 2, "TEXT is required"),
    (("say", " "), 2, "there is nothing to say"),
    (("say", "hello", "-o", ""), 2, "--output: an empty name"),
    (("say", "hello", "--component", "LogTaxi"), 2, "LogTaxi is no voice"),
    (("say", "hello", "-o", "none/x.wav"), 1, "cannot be written: " + NOWHERE),
    (("listen", "app"), 2, "FILE is required"),
    (("listen", "nobody", "x.wav"), 2, "there is no application 'nobody'"),
    (("test", "app", "--jobs", "0"), 2, "'0' is no whole number from 1"),
    (("test", "app", "--jobs", "-1"), 2, "'-1' is no whole number from 1"),
    (("test", "app", "nothing"), 2, "there is no conversation 'nothing'"),
    (("test", "app", ""), 2, "there is no conversation ''"),
    (("test", "app", "."), 2, FOLDER),
    (("test", "app", "pipe"), 2, PIPE),
    (("test", "app", "loop"), 2, LOOP),
    (("test", "app", "/dev/null"), 2, "this is a device, not a file"),
    (("test", "app", "--junit", ""), 2, "--junit: an empty name"),
    (("test", "app", "--junit", "none/x"), 1, "cannot be written: " + NOWHERE),
    (("test", "app", "--junit", "empty"), 1, "cannot be written: Is a dir"),
    (("test", "app", "--junit", "/dev/full"), 1, "written: No space left"),
    (("test", "app", "--junit", "x", "--watch"), 2, "excludes"),
    (("test", "talk-is-pipe"), 1, "/x.txt: error: " + PIPE),
    (("test", "talk-is-folder"), 1, "/x.txt: error: " + FOLDER),
    (("test", "talk-is-loop"), 1, LOOP),
    (("test", "talk-is-binary"), 1, "/x.txt:2:1: error: this is not UTF-8"),
    (("test", "talk-is-huge"), 1, "/x.txt: error: this file is larger than"),
    (("test", "talks-are-file"), 2, "dialogues: this folder cannot be read: "
     "Not a directory"),
    (("exec", "pipe"), 1, "pipe: error: " + PIPE),
    (("exec", "nothing"), 2, "there is no file or application 'nothing'"),
    (("exec", "broken"), 1, "speek"),
    (("exec", "no-main"), 1, "no-main: there is no function 'main'"),
    (("format", "nothing"), 2, "nothing: this file cannot be read: " + NOWHERE),
    (("format", "app"), 2, "app: " + FOLDER),
    (("format", "pipe"), 2, "pipe: " + PIPE),
    (("format", "file"), 1, "file:1:1: error: there is no element"),
    (("understand", "app"), 2, "TEXT is required"),
    (("completion", "fish"), 2, "fish"),
    (("help", "speek"), 2, "nothing is called 'speek', did you mean 'speak'"),
    (("help", "speak", "slot"), 2, "not expected: slot"),
    (("help", "--page", "x"), 2, "x not in {index,"),
    (("component", "LogTaxi"), 2, "parlour starts this by itself"),
    (("plugin",), 2, "subcommand is required"),
    (("plugin", "roles", "tts"), 2, "did you mean 'TTS'"),
    (("plugin", "new", "a b", "--role", "TTS"), 2, "no name for a plug-in"),
    (("plugin", "new", "A", "--role", "TTS", "--folder", "file"), 1,
     "cannot make the folder"),
    (("plugin", "new", "A", "--role", "TTS", "--folder", ""), 2, "empty name"),
    (("plugin", "test", "file.so"), 2, "file too short"),
    (("plugin", "test", "pipe.so"), 2, "there is no such file"),
    (("plugin", "test", "LogTaxi", "--option", "x"), 2, "lacks its '=value'"),
)


class UsageCase(ProgramCase):

    def setUp(self):
        super().setUp()
        os.chmod(self.folder, 0o755)
        self.make_application("app")
        (self.folder / "empty").mkdir()
        self.write("file", "x")
        os.mkfifo(self.folder / "pipe")
        (self.folder / "loop").symlink_to("loop")

    def make_application(self, name, talk="R: Hello.\n"):
        self.write(f"{name}/main.xml", SCRIPT)
        self.write(f"{name}/dialogues/hello.txt", talk)
        return self.folder / name

    def tried(self, *arguments, given="", **options):
        environment = {**os.environ, "XDG_DATA_HOME": str(self.folder / "home"),
                       **options.pop("environment", {})}
        return subprocess.run(
            options.pop("before", []) + [PROGRAM, *arguments], input=given,
            cwd=self.folder, env=environment, capture_output=True, timeout=60,
            check=False, encoding="utf-8", errors="replace", **options)


class Mistakes(UsageCase):

    def setUp(self):
        super().setUp()
        broken = self.make_application("broken") / "main.xml"
        broken.write_text(SCRIPT.replace("speak", "speek"), encoding="utf-8")
        self.write("no-main/x.xml", re.sub("(?m)^.*main.*\n", "", SCRIPT))
        os.mkfifo(self.folder / "pipe.so")
        self.write("file.so", "no plug-in")
        self.make_scripts()
        self.make_conversations()

    def make_scripts(self):
        new = {kind: self.make_application(f"script-is-{kind}") / "x.xml" for
               kind in ("pipe", "socket", "folder", "loop", "huge", "binary")}
        os.mkfifo(new["pipe"])
        with socket.socket(socket.AF_UNIX) as bound:
            bound.bind(os.path.relpath(new["socket"]))
        new["folder"].mkdir()
        new["loop"].symlink_to("x.xml")
        new["huge"].write_bytes(b"<!--" + b"x" * (17 << 20) + b"-->")
        new["binary"].write_bytes(b"\xff\xfe\0x")
        os.mkfifo(self.make_application("settings-are-pipe") / "settings.xml")
        (self.make_application("settings-are-nowhere") /
         "settings.xml").symlink_to("nowhere")
        os.mkfifo(self.make_application("sql-is-pipe") / "x.sql")
        self.write("sql-is-pipe/settings.xml", """<settings name="x">
            <Plugins><Plugin>SQLiteDatabase</Plugin></Plugins>
            <component name="SQLiteDatabase">
              <option name="schema" value="x.sql"/></component>
            <Scripts><Script>main.xml</Script></Scripts></settings>""")

    def make_conversations(self):
        new = {kind: self.make_application(f"talk-is-{kind}") /
               "dialogues/x.txt" for
               kind in ("pipe", "folder", "loop", "huge", "binary")}
        os.mkfifo(new["pipe"])
        new["folder"].mkdir()
        new["loop"].symlink_to("x.txt")
        new["huge"].write_bytes(b"# x\n" * (5 << 20))
        new["binary"].write_bytes(b"R: Hello.\nU: Caf\xe9\n")
        shutil.rmtree(self.make_application("talks-are-file") / "dialogues")
        self.write("talks-are-file/dialogues", "x")

    def test_each_is_told(self):
        before = {path for path in self.folder.rglob("*")}
        for arguments, status, words in MISTAKES:
            with self.subTest(arguments):
                ended = self.tried(*arguments)
                self.assertEqual(ended.returncode, status, ended)
                self.assertIn(words, ended.stdout + ended.stderr)
        made = {path for path in self.folder.rglob("*")} - before
        self.assertLessEqual({path.relative_to(self.folder).parts[0]
                              for path in made}, {"home"})

    def test_what_components_write_into_is_no_pipe(self):
        for plugin, name in (("TextFileTTS", "speech.txt"),
                             ("LogTaxi", "records/taxi.log")):
            self.write("voice/settings.xml", f"""<settings name="voice">
                <Plugins><Plugin>{plugin}</Plugin></Plugins>
                <Scripts><Script>main.xml</Script></Scripts></settings>""")
            self.write("voice/main.xml", SCRIPT)
            pipe = self.folder / "data" / name
            pipe.parent.mkdir(parents=True, exist_ok=True)
            os.mkfifo(pipe)
            ended = self.tried("run", "voice", "--data", "data")
            self.assertEqual(ended.returncode, 1, ended)
            self.assertIn(f"{name}: {plugin}: {PIPE}", ended.stderr)

    def test_what_an_editor_keeps_beside_a_file_counts_for_nothing(self):
        app = self.make_application("edited")
        (app / ".#main.xml").symlink_to("ada@desk.1234:1")
        (app / "dialogues/.#hello.txt").symlink_to("ada@desk.1234:1")
        self.assertEqual(self.tried("test", "edited").returncode, 0)

    def test_names_may_hold_anything(self):
        for name in ("two words", "Bärenstraße", "new\nline", "-", "a'b\"c"):
            with self.subTest(name):
                self.make_application(name)
                path = "./" + name
                self.assertEqual(self.tried("check", path).returncode, 0)
                self.assertEqual(self.tried("test", path).returncode, 0)
                ended = self.tried("run", path, "--data", path + "/data")
                self.assertEqual((ended.returncode, ended.stdout),
                                 (0, "Hello.\n"))


class Output(UsageCase):

    def setUp(self):
        super().setUp()
        self.write("broken/main.xml", SCRIPT.replace("speak", "speek"))

    def test_every_command_is_tried(self):
        listing = self.tried("--help").stdout.partition("Subcommands:")[2]
        names = set(re.findall(r"^  (\w+) ", listing, re.M))
        self.assertEqual(names - {words[0] for words in PRINTING}, NOT_TRIED)

    def remove_what_is_made(self):
        shutil.rmtree(self.folder / "EchoTTS", ignore_errors=True)
        (self.folder / "robot.key").unlink(missing_ok=True)
        (self.folder / "said.wav").unlink(missing_ok=True)

    def shell(self, arguments, line):
        self.remove_what_is_made()
        return self.tried(*arguments, given=SCRIPT,
                          before=["bash", "-c", line, "sh"])

    def test_that_cannot_be_written_is_told(self):
        for redirection, reason in ((">/dev/full", "No space left on device"),
                                    (">&-", "Bad file descriptor")):
            for arguments in PRINTING:
                with self.subTest((arguments, redirection)):
                    ended = self.shell(arguments, '"$@" ' + redirection)
                    self.assertEqual(ended.returncode, 1)
                    self.assertIn("error: what is printed cannot be written: " +
                                  reason, ended.stderr)

    def test_that_nobody_reads_ends_quietly(self):
        # Blocked until the reader is gone; then by the signal, or by itself
        # where that is ignored.
        line = '(read -r < go; trap "$0" PIPE; "$@"; echo $? >&2) | echo > go'
        os.mkfifo(self.folder / "go")
        for arguments in PRINTING:
            for trap in ("-", ""):
                with self.subTest((arguments, trap)):
                    self.remove_what_is_made()
                    ended = self.tried(*arguments, given=SCRIPT, before=[
                        "bash", "-c", line, trap])
                    self.assertEqual(ended.stderr.splitlines()[-1],
                                     "1" if "broken" in arguments and not trap
                                     else "141")
                    self.assertNotIn("error: what", ended.stderr)


class Permissions(UsageCase):
    """As somebody who may not read or write everything."""

    def setUp(self):
        super().setUp()
        self.somebody = {}
        if os.geteuid() == 0:
            self.somebody = {"user": "nobody", "group": "nogroup",
                             "extra_groups": []}
        try:
            self.tried("--version", **self.somebody)
        except PermissionError:
            self.skipTest("the program is where nobody else may go")

    def allow(self, name, mode):
        path = self.folder / name
        self.addCleanup(path.chmod, 0o755)
        path.chmod(mode)

    def refused(self, status, words, *arguments, **options):
        ended = self.tried(*arguments, **self.somebody, **options)
        with self.subTest(arguments):
            self.assertEqual(ended.returncode, status, ended)
            self.assertIn(words, ended.stdout + ended.stderr)

    def test_a_folder_that_may_not_be_read_is_told_as_such(self):
        for mode in (0, 0o644, 0o311):
            self.allow("app", mode)
            for command in (("run",), ("check",), ("test",), ("exec",),
                            ("plugin", "list")):
                self.refused(2, "app cannot be read: Permission denied",
                             *command, "app")
        self.refused(2, "folder cannot be read: Permission denied", "check",
                     "broken", "--plugins", "app")

    def test_files_that_may_not_be_read_are_told(self):
        denied = "this file cannot be read: Permission denied"
        self.allow("app/dialogues/hello.txt", 0)
        self.refused(1, "hello.txt: error: " + denied, "test", "app")
        self.allow("app/dialogues", 0)
        self.refused(2, "dialogues: this folder cannot be read: Permission "
                     "denied", "test", "app")
        self.allow("app/main.xml", 0)
        self.refused(1, "main.xml: error: " + denied, "check", "app")
        self.refused(2, "main.xml: " + denied, "format", "app/main.xml")

    def test_what_may_not_be_written_stays_as_it_was(self):
        denied = "cannot be written (Permission denied); it is as it was"
        talk = self.write("app/dialogues/hello.txt", "R: Hi.\n")
        script = self.write("app/main.xml",
                            SCRIPT.replace("<state ", "<state   "))
        self.allow("app/dialogues", 0o555)
        self.allow("app", 0o555)
        self.refused(1, denied, "test", "app", "--update")
        self.refused(1, denied, "format", "app/main.xml")
        self.refused(1, "cannot be made: Permission denied; --data names",
                     "run", "app", "--data", "app/data")
        script.write_text(SCRIPT.replace('"Hello"', "Hello"))
        self.refused(1, denied, "check", "app", "--fix")
        self.assertEqual(talk.read_text(), "R: Hi.\n")
        self.assertIn("name=Hello>", script.read_text())
        self.refused(1, "cannot write", "plugin", "new", "A", "--role", "TTS",
                     "--folder", "app")

    def test_no_home_and_no_place_for_temporary_files(self):
        for home in ("", "relative"):
            self.refused(1, "--data names a folder", "run", "app",
                         environment={"HOME": home, "XDG_DATA_HOME": ""})
        self.refused(1, "(TMPDIR says where): " + NOWHERE, "test", "app",
                     environment={"TMPDIR": "/nowhere"})


class Limits(UsageCase):
    """What the system gives no more of."""

    def run_with(self, limit, value):
        # pylint: disable=subprocess-popen-preexec-fn
        return self.tried("run", "app", preexec_fn=lambda: resource.setrlimit(
            limit, (value, value)))

    def test_descriptors(self):
        for count in (4, 5, 6):
            ended = self.run_with(resource.RLIMIT_NOFILE, count)
            self.assertEqual(ended.returncode, 1)
            self.assertIn("error: ", ended.stderr)

    def test_files_that_may_not_grow(self):
        app = self.make_application("kept")
        self.write("kept/settings.xml", """<settings name="kept">
            <Plugins><Plugin>SQLiteDatabase</Plugin></Plugins>
            <component name="SQLiteDatabase">
              <option name="file" value="x.db"/>
              <option name="schema" value="x.sql"/></component>
            <Scripts><Script>main.xml</Script></Scripts></settings>""")
        self.write("kept/x.sql", "create table t (x text);")
        ended = self.tried("run", str(app), preexec_fn=lambda:
                           resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0)))
        self.assertEqual(ended.returncode, 1)
        self.assertIn("x.db: SQLiteDatabase: The database cannot be written",
                      ended.stderr)


if __name__ == "__main__":
    unittest.main()
