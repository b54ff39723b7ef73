#!/usr/bin/env python3
"""Tests that `parlour exec` ends scripts which exceed their limits with an
error at a line and status 1, in bounded time and memory. With --measure it
prints a table of both."""

import os
import sys
import time
import unittest

from program_case import PROGRAM, ProgramCase

MEASURE = "--measure" in sys.argv
LONGEST = 120  # seconds, also of a debug build on a busy machine
# MB; a sanitizer adds to each piece, and keeps what was given back.
LARGEST = 2000 if "LSAN_OPTIONS" in os.environ else 400

DOUBLING = ('<var name="{0}" expr="{1}"/><while cond="true">'
            '<set name="{0}" expr="{2}"/></while>')
SHARED = ('<var name="l" expr="[1]"/><for name="i" from="1" to="60">'
          '<set name="l" expr="[l, l]"/></for>')
LARGE = '<var name="large" expr="range(1, 100000)"/>'
TEXT = '<var name="s" expr="join(range(1, 90000), \' \')"/>'

# What comes to its end by its instructions takes a while in a debug build.
LOOPS = [
    ("an endless loop of text", '<while cond="true">'
     '<var name="x" expr="upper(\'a\' + 1)"/></while>', "the script took"),
    ("a search for rings without end",
     LARGE + '<var name="l" expr="[]"/><var name="same" expr="l"/>'
     '<while cond="true"><append name="l" expr="large"/>'
     '<set name="l" expr="[]"/><set name="same" expr="l"/></while>',
     "the script took"),
    ("inserting in front without end",
     LARGE + '<while cond="true"><var name="x" expr="insert(large, 0, 1)"/>'
     '<set name="x" expr="remove(large, 0)"/></while>',
     "the script took"),
    ("comparing long texts without end",
     TEXT + '<var name="t" expr="s + \'x\'"/><set name="s" expr="s + \'y\'"/>'
     '<while cond="s ne t"><if cond="s lt t"/></while>',
     "the script took"),
    ("a regular expression without end",
     TEXT + '<while cond="matches(s, \'([0-9]|[1-9]|10)+x\') == false"/>',
     "the script took"),
    ("timers without end",
     '<timer name="t" after="1ms"><while cond="true"/></timer>',
     "the script took"),
]

# name, the statements of main, what is said
SCRIPTS = [
    ("an endless loop", '<while cond="true"/>', "the script took"),
    ("endless recursion", '<call function="main"/>', "more than 1000 calls"),
    ("endless recursion by two",
     '<call function="f"/></function><function name="f">'
     '<call function="main"/>', "more than 1000 calls"),
    ("a text of 2 GB", DOUBLING.format("s", "'ab'", "s + s"), "would hold more than"),
    ("a text of 2 GB by replace",
     TEXT + '<var name="x" expr="replace(s, \' \', s)"/>',
     "replace: the result would be larger"),
    ("a text of 2 GB by format",
     TEXT + '<var name="x" expr="{0}"/>'.format(
         "format('" + "{}" * 200 + "'" + ", s" * 200 + ")"), "format: the result would be larger"),
    ("a list of billions", DOUBLING.format("l", "[1]", "l + l"), "would hold more than"),
    ("an array of billions",
     '<object name="a" class="array" size="4000000000"/>', "more than the session may hold"),
    ("a range of billions", '<var name="x" expr="range(1, 4000000000)"/>',
     "range: "),
    ("a list put in itself",
     '<var name="l" expr="[1]"/><append name="l" expr="l"/>',
     "a list or map cannot be put inside of itself"),
    ("a list put in itself by a map",
     '<var name="l" expr="[1]"/><var name="m" expr="{\'k\': [l]}"/>'
     '<append name="l" expr="m"/>',
     "a list or map cannot be put inside of itself"),
    ("a map put in itself",
     '<var name="m" expr="{}"/><set name="m.k" expr="{\'n\': m}"/>',
     "a list or map cannot be put inside of itself"),
    ("printing what is shared inside", SHARED + '<print param="{l}"/>',
     "the text would be too long"),
    ("comparing what is shared inside",
     SHARED + '<var name="m" expr="[1]"/><for name="i" from="1" to="60">'
     '<set name="m" expr="[m, m]"/></for><if cond="l == m"/>',
     "too much to compare"),
    ("JSON of what is shared inside",
     SHARED + '<var name="x" expr="tojson(l)"/>', "tojson: "),
    ("giving away what is shared inside",
     SHARED + '<timer name="t" after="1ms"><print param="{l}"/></timer>',
     "too large to leave"),
    ("deep nesting",
     '<var name="l" expr="[1]"/><for name="i" from="1" to="5000">'
     '<set name="l" expr="[l]"/></for><print param="{l}"/>', "the text would be too long"),
]

# name, the file, what is said
FILES = [
    ("nothing", b"", "main.xml:1:1: error: "),
    ("no XML", b"hello", "main.xml:1:"),
    ("bytes", bytes(range(256)) * 100, "main.xml:3:"),
    ("an element left open", b"<dialogue>\n<function name='main'>",
     "main.xml:2:"),
    ("a tag that does not end", b"<dialogue>\n<function name='main'",
     "main.xml:2:"),
    ("another encoding", "<dialogue/>".encode("utf-16"), "main.xml:"),
    ("entities of entities",
     b"<!DOCTYPE d [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;'>]>\n<d>&b;</d>",
     "main.xml:1:"),
    ("100,000 elements in each other",
     b"<dialogue>" + b"<if cond='1'>" * 100_000, "main.xml:1:"),
    ("a million brackets",
     b"<dialogue>\n<function name='main'><var name='x' expr='" +
     b"(" * 1_000_000 + b"'/></function></dialogue>", "main.xml:2:"),
    ("a megabyte of mistakes",
     b"<dialogue><function name='main'>" + b"\n<prnt param='{x}'/>" * 50_000 +
     b"</function></dialogue>", "main.xml:2:"),
    ("no main", b"<dialogue/>", "there is no function 'main'"),
]


def run(script):
    """Its output, status, seconds and the most megabytes it held."""
    started = time.monotonic()
    read, write = os.pipe()
    process = os.posix_spawn(
        PROGRAM, [PROGRAM, "exec", str(script)], os.environ,
        file_actions=[(os.POSIX_SPAWN_DUP2, write, 1),
                      (os.POSIX_SPAWN_DUP2, write, 2)])
    os.close(write)
    with os.fdopen(read, encoding="utf-8", errors="replace") as output:
        said = output.read()
    _, status, usage = os.wait4(process, 0)
    return (said, os.waitstatus_to_exitcode(status),
            time.monotonic() - started, usage.ru_maxrss / 1024)


def programs():
    for name, statements, expected in SCRIPTS + (LOOPS if MEASURE else []):
        yield name, (f"<dialogue><function name='main'>\n{statements}\n"
                     "</function></dialogue>").encode(), expected
    for name, text, expected in FILES:
        yield name, text, expected


class Bounds(ProgramCase):

    def setUp(self):
        super().setUp()
        self.script = self.folder / "main.xml"

    def test_each_ends_with_a_clear_error(self):
        for name, text, expected in programs():
            with self.subTest(name):
                self.script.write_bytes(text)
                said, status, seconds, megabytes = run(self.script)
                if MEASURE:
                    print(f"{seconds:7.2f} s {megabytes:5.0f} MB  {name}: "
                          f"{said[:200]!r}")
                self.assertEqual(status, 1, said[:1000])
                self.assertIn(expected, said[:10_000])
                self.assertRegex(said[:10_000], r"main\.xml|there is no")
                self.assertLess(seconds, LONGEST)
                self.assertLess(megabytes, LARGEST)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
