#!/usr/bin/env python3
"""Serves an application and visits it: the examples of its protocol, people, and
the end by a signal."""

import json
import pathlib
import re
import signal
import socket
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import ProgramCase  # noqa: E402

ROOT = pathlib.Path(__file__).parents[4]
APP = """<dialogue>
  <state name="Desk"><Entrance><speak param="Hello."/></Entrance>
    <Exit><speak param="Bye."/></Exit></state>
  <handler name="Echo"><messages><component><ASR><RecognitionResult>
    <speak param="You said: {_LPARAM1}"/>
    <if cond="_LPARAM1 == 'that is all'"><end/></if>
  </RecognitionResult></ASR></component></messages></handler>
</dialogue>
"""
SETTINGS = """<settings name="desk" start="Desk"><Scripts><Script>desk.xml</Script>
</Scripts></settings>
"""


class Visitor:

    def __init__(self, address):
        host, port = address.rsplit(":", 1)
        self.socket = socket.create_connection((host, int(port)), timeout=20)
        self.file = self.socket.makefile("rw", encoding="utf-8", newline="\n")

    def send(self, line):
        self.file.write(line + "\n")
        self.file.flush()

    def read(self):
        return self.file.readline().rstrip("\n")

    def close(self):
        self.file.close()
        self.socket.close()


class ServeTest(ProgramCase):

    def serve(self, *options):
        self.write("app/settings.xml", SETTINGS)
        self.write("app/desk.xml", APP)
        server = self.begin("serve", "app", "--port", "0", "--data", "data",
                            *options, cwd=self.folder, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        line = server.stdout.readline()
        self.assertRegex(line, "^desk is served at ")
        self.address = re.search(r"at (\S+) ", line)[1]
        return server

    def visit(self):
        visitor = Visitor(self.address)
        self.addCleanup(visitor.close)
        return visitor

    def end(self, server):
        server.send_signal(signal.SIGTERM)
        _, errors = server.communicate(timeout=60)
        self.assertEqual(server.returncode, 0, errors)
        return errors

    def test_the_examples_of_the_protocol(self):
        server = self.serve()
        page = (ROOT / "adapters/web/PROTOCOL.md").read_text(encoding="utf-8")
        examples = re.findall(r"^```dialogue\n(.*?)^```", page, re.S | re.M)
        self.assertGreater(len(examples), 2)
        visitor, session = self.visit(), ""
        for line in "".join(examples).splitlines():
            if line.startswith("!"):
                visitor.close()
                visitor = self.visit()
            elif line.startswith(">"):
                visitor.send(line[2:].replace('"…"', f'"{session}"'))
            else:
                said = visitor.read()
                session = json.loads(said).get("session", session)
                pattern = re.escape(line[2:]).replace("…", "[^\"]*")
                self.assertRegex(said, f"^{pattern}$")
        self.assertEqual(visitor.read(), "")
        self.assertIn("1 visitors, 2 turns, 1 resumed, 0 refused",
                      self.end(server))

    def test_people_come_and_go(self):
        server = self.serve("--sessions", "1", "--clock", "2026-11-21 09:00")
        for _ in range(3):
            person = self.visit()
            person.send("good morning")
            self.assertEqual(person.read(), "Hello.")
            self.assertEqual(person.read(), "You said: good morning")
            other = self.visit()
            other.send("hello?")
            self.assertIn("all 1 places are taken", other.read())
            person.send("that is all")
            self.assertEqual(person.read(), "You said: that is all")
            self.assertEqual(person.read(), "Bye.")
            self.assertEqual(person.read(), "")
        self.assertIn("3 refused", self.end(server))

    def test_all_sessions_end_in_order(self):
        server = self.serve()
        people = [self.visit() for _ in range(5)]
        for person in people:
            person.send("hello")
            person.read()
            person.read()
        errors = self.end(server)
        for person in people:
            self.assertEqual(person.read(), "Bye.")
            self.assertEqual(person.read(), "")
        self.assertIn("5 visitors, 5 turns", errors)

    def test_a_load_is_played_and_checked(self):
        self.serve()
        self.write("app/dialogues/one.txt",
                   "R: Hello.\nU: one\nR: You said: one\nU: that is all\n"
                   "R: You said: that is all\nR: Bye.\n")
        self.write("app/dialogues/two.txt", "R: Hello.\nU: two\nR: Two.\n")
        for way in (), ("--lines",):
            played = self.begin("load", "app", "--to", self.address,
                                "--visitors", "10", *way, cwd=self.folder,
                                text=True, stdout=subprocess.PIPE)
            lines, _ = played.communicate(timeout=60)
            self.assertEqual(played.returncode, 1)
            self.assertIn("5 conversations, 10 turns", lines)
            self.assertIn("5 wrong answers, 0 errors", lines)
            self.assertIn("two.txt:3: expected R: Two., found R: You said: two",
                          lines)

    def test_a_port_that_is_taken(self):
        self.serve()
        second = self.begin("serve", "app", "--data", "other", "--port",
                            self.address.rsplit(":", 1)[1], cwd=self.folder,
                            text=True, stderr=subprocess.PIPE)
        _, errors = second.communicate(timeout=60)
        self.assertEqual(second.returncode, 1)
        self.assertIn("already in use", errors)


if __name__ == "__main__":
    unittest.main()
