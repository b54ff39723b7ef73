#!/usr/bin/env python3
"""Watches a server as its operator does: metrics, health, top and tail, while
visitors talk with it."""

import os
import pathlib
import re
import select
import signal
import socket
import subprocess
import sys
import time
import unittest
import urllib.error
import urllib.request

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import ProgramCase  # noqa: E402

APP = """<dialogue>
  <state name="Desk"><Entrance><speak param="Hello."/></Entrance></state>
  <topic name="Card"><slot name="Code" type="Functional" private="true"
    question="Your code?"><cardinality type="set"><value>tango</value>
    </cardinality></slot></topic>
  <handler name="Echo"><messages><component><ASR><RecognitionResult>
    <speak param="You said: {_LPARAM1}"/>
    <if cond="_LPARAM1 == 'log it'"><log level="warning" param="noted"/></if>
  </RecognitionResult></ASR></component></messages></handler>
</dialogue>
"""
SETTINGS = """<settings name="desk" start="Desk"><Scripts><Script>desk.xml</Script>
</Scripts></settings>
"""
ROOT = pathlib.Path(__file__).parents[4]


class WatchingTest(ProgramCase):

    def setUp(self):
        super().setUp()
        self.environment = {**os.environ, "XDG_RUNTIME_DIR": str(self.folder)}
        self.write("app/settings.xml", SETTINGS)
        self.write("app/desk.xml", APP)

    def serve(self, *options):
        server = self.begin("serve", "app", "--port", "0", "--data", "data",
                            *options, cwd=self.folder, text=True,
                            env=self.environment, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE)
        if "--metrics" in options:
            line = server.stderr.readline()
            self.assertRegex(line, r"^metrics at http://127.0.0.1:\d+/metrics")
            self.pages = line.split()[-1].rsplit("/", 1)[0]
        line = server.stdout.readline()
        self.assertRegex(line, "^desk is served at ")
        self.address = re.search(r"at (\S+) ", line)[1]
        return server

    def end(self, server):
        server.send_signal(signal.SIGTERM)
        _, errors = server.communicate(timeout=60)
        self.assertEqual(server.returncode, 0, errors)
        return errors

    def say(self, *lines):
        """A person says these; returned are the answers."""
        host, port = self.address.rsplit(":", 1)
        with socket.create_connection((host, int(port)), timeout=20) as person:
            file = person.makefile("rw", encoding="utf-8", newline="\n")
            heard = []
            for line in lines:
                file.write(line + "\n")
                file.flush()
                while not heard or not heard[-1].startswith("You said"):
                    heard.append(file.readline().strip())
                heard.append("")
            return [line for line in heard if line]

    def get(self, page):
        with urllib.request.urlopen(self.pages + page, timeout=20) as answer:
            return answer.read().decode()

    def metrics(self):
        return dict(line.rsplit(" ", 1)
                    for line in self.get("/metrics").splitlines()
                    if not line.startswith("#"))

    def ask(self, *arguments):
        asked = self.begin(*arguments, cwd=self.folder, text=True,
                           env=self.environment, stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE)
        out, errors = asked.communicate(timeout=60)
        return asked.returncode, out, errors

    def test_metrics_and_health(self):
        server = self.serve("--metrics", "0")
        self.assertEqual(self.say("one", "two"),
                         ["Hello.", "You said: one", "You said: two"])
        # A turn counts when nothing more comes of it, after its answer.
        values = self.metrics()
        latest = time.monotonic() + 20
        while (values["parlour_turns_total"] != "2"
               and time.monotonic() < latest):
            values = self.metrics()
        self.assertEqual(values["parlour_turns_total"], "2")
        self.assertEqual(values["parlour_turn_seconds_count"], "2")
        self.assertEqual(values["parlour_sessions_opened_total"], "1")
        self.assertEqual(values["parlour_visitors_total"], "1")
        self.assertEqual(values['parlour_actor_answers{actor="supervisor"}'],
                         "1")
        self.assertEqual(self.get("/health"), "well\n")
        with self.assertRaises(urllib.error.HTTPError) as refused:
            self.get("/nothing")
        self.assertEqual(refused.exception.code, 404)
        refused.exception.close()
        self.end(server)

    def test_the_page_of_documentation_names_all_metrics(self):
        server = self.serve("--metrics", "0", "--journal", "kept")
        page = (ROOT / "docs/operations.md").read_text(encoding="utf-8")
        told = set(re.findall(r"^# TYPE (\S+)", self.get("/metrics"), re.M))
        named = set()
        for name in re.findall(r"`((?:parlour|process)_[^`]*)`", page):
            name = name.replace("{route}", "").replace("{component}", "")
            name = name.replace("{actor}", "").replace("{component,role}", "")
            choice = re.search(r"\{(.*?)\}", name)
            for word in choice[1].split(",") if choice else [""]:
                named.add(name.replace(choice[0], word) if choice else name)
        self.assertEqual(told, named)
        self.end(server)

    def test_top_prints_once_where_no_terminal_is(self):
        server = self.serve()
        self.say("one", "two", "three")
        status, out, errors = self.ask("top", "desk")
        self.assertEqual(status, 0, errors)
        self.assertRegex(out, r"^desk \(process \d+, .*/app\), up 0:00:")
        self.assertIn("; 3 in all, 0 script errors\n", out)
        self.end(server)
        status, _, errors = self.ask("top", "desk")
        self.assertEqual(status, 1)
        self.assertIn("'desk' does not run", errors)

    def test_tail_follows_with_a_filter(self):
        server = self.serve()
        tail = self.begin("tail", "--kind", "message", "--kind", "log",
                          cwd=self.folder, text=True, env=self.environment,
                          stdout=subprocess.PIPE)
        # Something is said until it is heard at the other end.
        while not select.select([tail.stdout], [], [], 0)[0]:
            self.say("log it")
        self.say("log it")
        errors = self.end(server)
        seen = tail.stdout.read()
        self.assertEqual(tail.wait(timeout=60), 0)
        self.assertRegex(
            seen, r"(?m)^\d\d:\d\d:\d\d\.\d{3}  [0-9a-f]+  (1|-)  message     "
            r"ASR\.RecognitionResult\(log it")
        self.assertRegex(
            seen, r"(?m)^\d\d:\d\d:\d\d\.\d{3}  [0-9a-f]+  1  log         "
            r"warning: noted$")
        self.assertNotIn("  output  ", seen)
        # Logs name session and turn.
        self.assertRegex(errors,
                         r"warning: noted  \(session [0-9a-f]+, turn 1\)\n")

    def test_an_address_that_is_none(self):
        for given in "nonsense", "1:2:3", "99999":
            status, _, errors = self.ask("serve", "app", "--metrics", given)
            self.assertEqual(status, 2, errors)
            self.assertIn("neither a port nor an address", errors)
        status, _, errors = self.ask("serve", "app", "--port", "0",
                                     "--metrics", "nowhere:0")
        self.assertEqual(status, 1)
        self.assertIn("no pages can be served at nowhere", errors)


if __name__ == "__main__":
    unittest.main()
