#!/usr/bin/env python3
"""Tests scripts that use files below data/, sockets and transactions, in a
running application and with `parlour exec`."""

import os
import pathlib
import socket
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import PROGRAM, ProgramCase  # noqa: E402

SETTINGS = """<settings name="outside">
  <Plugins><Plugin>SQLiteDatabase</Plugin></Plugins>
  <component name="SQLiteDatabase">
    <option name="file" value="bank.db"/>
    <option name="schema" value="schema.sql"/>
  </component>
  <Scripts><Script>outside.xml</Script></Scripts>
</settings>"""

SCRIPT = r"""<dialogue>
  <function name="payments">
    <querydb param="select count(*) from payment" return="rows"/>
    <return expr="rows[0]"/>
  </function>
  <function name="obey">
    <param name="words"/>
    <switch expr="words[0]">
      <case value="pay">
        <connectdb param="SQLiteDatabase" write="true"/>
        <transaction>
          <querydb param="insert into payment values (?)" args="words[1]"/>
          <if cond="payments() == 3"><throw expr="'enough'"/></if>
        </transaction>
        <speak param="paid {payments()}"/>
      </case>
      <case value="count"><speak param="{payments()} payments"/></case>
      <case value="note">
        <appendfile name="notes/{words[1]}.txt" param="{words[2]};"/>
        <readfile name="notes/{words[1]}.txt" return="text"/>
        <speak param="{text}"/>
      </case>
      <case value="read">
        <readfile name="{words[1]}" return="text"/>
        <speak param="{text}"/>
      </case>
      <case value="list">
        <listfiles name="*/*" return="names"/>
        <speak param="{names}"/>
      </case>
      <case value="open">
        <socket name="feed" connect="127.0.0.1:{words[1]}"/>
        <sendsocket name="feed" param="hello{'\n'}"/>
        <speak param="open"/>
      </case>
    </switch>
  </function>
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <try>
        <call function="obey"><var expr="split(_LPARAM1)"/></call>
        <catch name="e"><speak param="{e.kind}: {e.message}"/></catch>
      </try>
    </RecognitionResult></ASR>
    <feed>
      <Data><speak param="got {_LPARAM1}"/></Data>
      <Closed><speak param="closed: {_LPARAM1}"/></Closed>
    </feed>
  </component></messages></handler>
</dialogue>"""


class Outside(ProgramCase):

    def setUp(self):
        super().setUp()
        self.write("app/settings.xml", SETTINGS)
        self.write("app/outside.xml", SCRIPT)
        self.write("app/schema.sql", "create table payment (what text);")
        self.write("secret.txt", "secret")

    def arguments(self):
        return ["run", str(self.folder / "app"), "--text", "--data",
                str(self.folder / "data")]

    def say(self, *lines):
        """What is answered to rows of one line each."""
        ended = subprocess.run(
            [PROGRAM, *self.arguments()],
            input="".join(line + "\n\n" for line in lines), capture_output=True, timeout=60, check=False, encoding="utf-8")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return [line for line in ended.stdout.splitlines() if line]

    def execute(self, *statements):
        """The end of a script beside a folder data/."""
        script = self.write("script/main.xml",
                            "<dialogue><function name='main'>" +
                            "".join(statements) + "</function></dialogue>")
        (self.folder / "script/data").mkdir(exist_ok=True)
        return subprocess.run([PROGRAM, "exec", str(script)],
                              capture_output=True, timeout=60, check=False,
                              encoding="utf-8")

    # -- a running application ------------------------------------------------

    def test_a_transaction_is_kept_or_undone(self):
        self.assertEqual(
            self.say("pay a", "pay b", "pay c", "count", "pay d", "count"),
            ["paid 1", "paid 2", "Thrown: enough", "2 payments",
             "Thrown: enough", "2 payments"])

    def test_files_are_kept_in_the_data_folder(self):
        self.assertEqual(
            self.say("note ann one", "note ann two", "note ben x", "list"),
            ["one;", "one;two;", "x;", "[notes/ann.txt, notes/ben.txt]"])
        kept = self.folder / "data/notes/ann.txt"
        self.assertEqual(kept.read_text(), "one;two;")

    def test_no_name_leads_out_of_it(self):
        (self.folder / "data").mkdir()
        (self.folder / "data/link").symlink_to(self.folder / "secret.txt")
        said = self.say("read ../secret.txt", "read /etc/passwd", "read link",
                        "note ../../app x")
        self.assertEqual(len(said), 4)
        for line in said:
            self.assertTrue(line.startswith("File: "), line)

    def test_a_socket_talks(self):
        with socket.create_server(("127.0.0.1", 0)) as server:
            running = self.begin(
                *self.arguments(), stdin=subprocess.PIPE,
                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                encoding="utf-8")
            server.settimeout(60)
            running.stdin.write(f"open {server.getsockname()[1]}\n\n")
            running.stdin.flush()
            other, _ = server.accept()
            self.assertEqual(other.recv(6), b"hello\n")
            other.sendall("one\r\ntw\u00f6".encode())
            other.close()
            lines = self.read(running.stdout, 4)
        self.assertEqual(lines, ["open", "got one", "got tw\u00f6",
                                 "closed: the other side closed it"])

    def read(self, stream, count):
        lines = []
        while len(lines) < count:
            line = stream.readline()
            self.assertTrue(line, lines)
            lines += [line.strip()] if line.strip() else []
        return lines

    def test_a_socket_to_nobody(self):
        with socket.create_server(("127.0.0.1", 0)) as server:
            port = server.getsockname()[1]
        self.assertEqual(
            self.say(f"open {port}"),
            [f"Network: no connection to 127.0.0.1:{port}: "
             "Connection refused"])

    # -- exec -----------------------------------------------------------------

    def test_exec_keeps_files_beside_the_script(self):
        ended = self.execute("<writefile name='a/b.txt' param='text'/>",
                             "<readfile name='a/b.txt' return='t'/>",
                             "<print param='{t}'/>")
        self.assertEqual((ended.stdout, ended.returncode), ("text\n", 0))
        kept = self.folder / "script/data/a/b.txt"
        self.assertEqual(kept.read_text(), "text")

    def test_exec_refuses_what_lies_outside(self):
        data = self.folder / "script/data"
        data.mkdir(parents=True)
        (data / "file").symlink_to(self.folder / "secret.txt")
        (data / "folder").symlink_to(self.folder)
        (data / "root").symlink_to("/")
        os.link(self.folder / "secret.txt", data / "hard")
        os.mkfifo(data / "pipe")
        names = ["../main.xml", "../../secret.txt", "/etc/passwd",
                 str(self.folder / "secret.txt"), "a/../../main.xml",
                 "./../main.xml", "file", "folder/secret.txt",
                 "root/etc/passwd", "hard", "pipe", "file/", "..", ".", "",
                 "a\\..\\b", "%2e%2e/main.xml", "DATA/../../main.xml"]
        for name in names:
            for statement in (f"<readfile name='{name}' return='t'/>",
                              f"<appendfile name='{name}' param='x'/>"):
                if name.startswith("%") and "append" in statement:
                    continue  # a name like any other
                ended = self.execute(statement)
                self.assertEqual(ended.returncode, 1, (statement, ended))
                self.assertIn("main.xml:1: ", ended.stderr)
                self.assertEqual(ended.stdout, "")
        self.assertEqual((self.folder / "secret.txt").read_text(), "secret")

    def test_exec_does_not_follow_a_linked_data_folder(self):
        (self.folder / "script").mkdir()
        (self.folder / "script/data").symlink_to(self.folder)
        ended = self.execute("<readfile name='secret.txt' return='t'/>")
        self.assertEqual(ended.returncode, 1)
        self.assertIn("link", ended.stderr)

    def test_exec_has_neither_sockets_nor_databases(self):
        for statement in ("<socket name='s' connect='localhost:1'/>",
                          "<transaction/>"):
            ended = self.execute(statement)
            self.assertEqual(ended.returncode, 1)
            self.assertIn("needs a running application", ended.stderr)


if __name__ == "__main__":
    unittest.main()
