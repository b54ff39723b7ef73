#!/usr/bin/env python3
"""Tests each fenced block of each page: it is run if its page is run as a whole
(tutorial, test, plug-ins), otherwise checked by itself. A block of neither kind
fails."""

import json
import re
import shutil
import unittest
from pathlib import Path

from page_case import ROOT, PageCase, blocks_of

PAGES = sorted((ROOT / "docs").glob("*.md")) + [ROOT / "README.md"]
RUN = {"tutorial.md", "plugins.md", "test.md", "engine.md", "services.md"}  # by the tests called so

# Pages whose XML is compared with an application by tests of their own.
HELD = {"writing.md", "repair.md"}

# What may surround an example in XML.
AROUND = (
    "{text}",
    "<dialogue>{text}</dialogue>",
    "<dialogue><topic name='X'>{slots}{text}</topic></dialogue>",
    "<dialogue><function name='x'>{text}</function></dialogue>",
    "<settings name='x'>{text}</settings>",
    "<settings name='x'><Plugins><Plugin>GrammarNLU</Plugin>"
    "<Plugin>SQLiteDatabase</Plugin></Plugins>{text}</settings>",
    "<settings name='x'><Plugins><Plugin>MySQLDatabase</Plugin></Plugins>"
    "<component name='MySQLDatabase'>{text}</component></settings>")
# XML elements of other languages.
FOREIGN = ("<locatingRules ", "<keywords>")
# Conversations have no name.
TRIED = {"", "sh", "bash", "json", "xml"}
PICTURES = {"text", "vim", "python"}
# Commands of other programs, or ones that change the machine.
OTHERS = ("trang ", "git clone ", "tools/run", "tools/test", "tools/install",
          "export ", "parlour status", "parlour agent", "python3 tools/",
          "parlour tap", "parlour replay", "parlour journal", "parlour run butler",
          "parlour devices", "parlour serve", "parlour load", "parlour top",
          "parlour tail", "parlour reload", "nc ")


class Pages(PageCase):
    def blocks(self, *languages):
        for page in PAGES:
            for info, text in blocks_of(page.read_text(encoding="utf-8")):
                if info.split(" ")[0] in languages and page.name not in RUN:
                    yield page.name, text

    def test_every_block_is_of_a_kind_that_is_tried(self):
        for page in PAGES:
            if page.name in RUN:
                continue
            for info, text in blocks_of(page.read_text(encoding="utf-8")):
                self.assertIn(info, TRIED | PICTURES, f"{page.name}: {text}")

    def test_commands_are_those_of_the_program(self):
        for name in ("FOLDER", "APP"):
            shutil.copytree(ROOT / "config/apps/lab", self.work / name)
        for name in ("lines", "sentences.txt", "marked.jsonl"):
            (self.work / name).touch()
        (self.work / "FILE.xml").write_text(
            "<dialogue><function name='main'/></dialogue>", encoding="utf-8")
        self.environment["HOME"] = self.folder.name
        (Path(self.folder.name) / ".config").mkdir()
        count = 0
        for name, text in self.blocks("sh", "bash"):
            for line in text.splitlines():
                if line.startswith(OTHERS):
                    continue
                line = line.replace("| tools/run --",
                                    "| parlour run receptionist")
                # The receptionist's are run by a test of their own.
                line = line.replace("test receptionist", "test lab")
                with self.subTest(page=name, line=line):
                    self.run_commands(line + "\n")
                    count += 1
        self.assertGreater(count, 10)

    def test_the_first_command_is_written_as_it_is_used(self):
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            self.assertNotRegex(text, r"tools/run +[a-z]", page.name)

    def test_examples_in_xml_are_right(self):
        count = 0
        for name, text in self.blocks("xml"):
            if text.startswith(FOREIGN) or name in HELD:
                continue
            with self.subTest(page=name, text=text[:60]):
                self.check(text.replace("…", ""))
                count += 1
        self.assertGreater(count, 8)

    def check(self, text):
        """Checks that the XML is correct in one of the possible contexts."""
        file = self.work / "example.xml"
        text = re.sub("^<Plugin>.*</Plugin>$", r"<Plugins>\g<0></Plugins>",
                      text, flags=re.M)
        slots = "".join(f"<slot name='{name}'/>" for name in
                        sorted(set(re.findall(r"\]\((\w+)\)", text))))
        said = []
        for around in AROUND:
            file.write_text(around.format(text=text, slots=slots),
                            encoding="utf-8")
            printed = self.run_commands("parlour check --json example.xml "
                                        "2>/dev/null || true")
            found = [one["message"] for one in json.loads(printed)
                     if one["kind"] == "error"]
            if not found:
                return
            said.append(found)
        self.fail(said)

    def test_json_is_json(self):
        for name, text in self.blocks("json"):
            with self.subTest(page=name):
                json.loads(text)

    def test_conversations_can_be_read(self):
        for name, text in self.blocks(""):
            (self.work / "example.txt").write_text(text, encoding="utf-8")
            with self.subTest(page=name):
                # It is only a part of a conversation, so it may fail when run.
                printed = self.run_commands(
                    "parlour test -q receptionist example.txt 2>&1 || true")
                self.assertRegex(printed, r"[01] of 1 conversations passed")

    def test_links_lead_somewhere(self):
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            text = re.sub(r"^ *```.*?^ *```|`[^`\n]*`", "", text,
                          flags=re.M | re.S)
            for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", text):
                with self.subTest(page=page.name, target=target):
                    self.assertTrue((page.parent / target).exists())
            headings = {re.sub(r"[^\w -]", "", line.lower()).replace(" ", "-")
                        for line in re.findall(r"^#+ (.*)$", text, re.M)}
            for anchor in re.findall(r"\]\(#([^)]*)\)", text):
                self.assertIn(anchor, headings, page.name)


class TestPage(PageCase):
    def test_the_page_does_what_it_says(self):
        self.assertEqual(self.try_out("test.md"), 2)


if __name__ == "__main__":
    unittest.main()
