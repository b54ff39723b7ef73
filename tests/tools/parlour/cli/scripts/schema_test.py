#!/usr/bin/env python3
"""Tests the schemas that `parlour schema` prints, with xmllint: they accept
every application of the tree and reject mistakes."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

PROGRAM = os.environ.get("PARLOUR_PROGRAM", "build/debug/bin/parlour")
ROOT = pathlib.Path(__file__).resolve().parents[5]
# What a plug-in reads is not ours to describe.
RIGHT = [path for folder in ("config", "tests/fixtures")
         for path in sorted((ROOT / folder).rglob("*.xml"))
         if ElementTree.parse(path).getroot().tag not in ("keywords", "service")]
WRONG = {
    "misspelt element": "<dialogue><stat name='a'/></dialogue>",
    "misplaced element": "<dialogue><print param='a'/></dialogue>",
    "case outside of switch": "<dialogue><function name='f'>"
                              "<case value='1'/></function></dialogue>",
    "misspelt attribute": "<dialogue><var nmae='a'/></dialogue>",
    "missing attribute": "<dialogue><state/></dialogue>",
    "wrong word": "<dialogue><topic name='t' kind='question'/></dialogue>",
    "wrong boolean": "<dialogue><function name='f'>"
                     "<speak param='a' interrupt='maybe'/></function>"
                     "</dialogue>",
    "wrong duration": "<dialogue><function name='f'><wait for='soon'/>"
                      "</function></dialogue>",
    "wrong name": "<dialogue><var name='1 a'/></dialogue>",
    "statement in an event": "<dialogue><handler name='h'><messages>"
                             "<component><ASR><RecognitionResult><speek/>"
                             "</RecognitionResult></ASR></component>"
                             "</messages></handler></dialogue>",
    "text between statements": "<dialogue><function name='f'>hello"
                               "</function></dialogue>",
    "wrong root": "<script/>",
}
# What XSD cannot say.
WRONG_COMPANY = {
    "attributes that exclude each other":
        "<dialogue><function name='f'><for each='x' in='l' from='1' to='2'/>"
        "</function></dialogue>",
    "half of a form": "<dialogue><function name='f'><for name='i' from='1'/>"
                      "</function></dialogue>",
    "an attribute of another word": "<dialogue><topic name='t'><slot name='s'>"
                                    "<cardinality type='date' from='1'/>"
                                    "</slot></topic></dialogue>",
    "said by an attribute and a child":
        "<dialogue><function name='f'><post module='A' command='b' param='1'>"
        "<param expr='2'/></post></function></dialogue>",
    "a value computed and written": "<dialogue><topic name='t'><slot name='s'>"
                                    "<help><value expr='1'>one</value></help>"
                                    "</slot></topic></dialogue>",
    "a second entrance": "<dialogue><state name='s'><Entrance/><Exit/>"
                         "<entrance/></state></dialogue>",
    "a second default": "<dialogue><function name='f'><switch expr='1'>"
                        "<default/><case value='1'/><default/></switch>"
                        "</function></dialogue>",
    "elseif behind else": "<dialogue><function name='f'><if cond='a'><else/>"
                          "<elseif cond='b'/></if></function></dialogue>",
    "a statement behind catch": "<dialogue><function name='f'><try><catch/>"
                                "<end/></try></function></dialogue>",
}
ODD = {
    "first letters": "<Dialogue><function name='f'><Print param='a'/>"
                     "<wait for='{x}'/></function></Dialogue>",
    "names beyond ASCII": "<dialogue><var name='größe'/></dialogue>",
    "any source": "<dialogue><handler name='h'><messages><component><MyOwn>"
                  "<Event><speak param='a'/></Event></MyOwn></component>"
                  "<on source='*' event='*'/></messages></handler></dialogue>",
    "parts in front of their statements":
        "<dialogue><function name='f'><if cond='a'><end/><elseif cond='b'/>"
        "<end/><end/><else/><if cond='c'><end/><Else/></if></if></function>"
        "</dialogue>",
    "all of a state": "<dialogue><state name='s'><Online/><functions/><Exit/>"
                      "<functions/><Entrance/><messages/></state></dialogue>",
    "forms": "<dialogue><function name='f'><for in='l' each='x'/><cancel/>"
             "<cancel all='true'/><fire event='e' param='1'/><fire event='e'>"
             "<param expr='1'/></fire></function></dialogue>",
    "free columns": "<dialogue><facts><fact a='1' b='2'/></facts></dialogue>",
}


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.schemas = {}
        for option, arguments in (("--relaxng", []), ("--schema", ["--xsd"])):
            text = subprocess.run([PROGRAM, "schema", *arguments], check=True,
                                  capture_output=True).stdout
            path = pathlib.Path(cls.folder.name) / option.strip("-")
            path.write_bytes(text)
            cls.schemas[option] = path

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def judge(self, option, *arguments, **more):
        return subprocess.run(
            ["xmllint", "--noout", option, str(self.schemas[option]),
             *arguments], capture_output=True, text=True, **more)

    def test_accepts_what_is_right(self):
        self.assertGreater(len(RIGHT), 10)
        for option in self.schemas:
            said = self.judge(option, *map(str, RIGHT))
            self.assertEqual(said.returncode, 0, said.stderr)

    def test_accepts_what_is_odd(self):
        for option in self.schemas:
            for name, text in ODD.items():
                with self.subTest(option=option, case=name):
                    said = self.judge(option, "-", input=text)
                    self.assertEqual(said.returncode, 0, said.stderr)

    def test_refuses_what_is_wrong(self):
        for option in self.schemas:
            for name, text in WRONG.items():
                with self.subTest(option=option, case=name):
                    said = self.judge(option, "-", input=text)
                    self.assertIn(said.returncode, (3, 4), said.stderr)

    def test_refuses_wrong_company(self):
        for name, text in WRONG_COMPANY.items():
            with self.subTest(case=name):
                said = self.judge("--relaxng", "-", input=text)
                self.assertIn(said.returncode, (3, 4), said.stderr)


if __name__ == "__main__":
    sys.exit(unittest.main())
