#!/usr/bin/env python3
"""Tests the steps of docs/services.md, and each example of rules in it."""

import json
import unittest

from page_case import ROOT, PageCase, blocks_of

PAGE = (ROOT / "docs" / "services.md").read_text(encoding="utf-8")
PARAMS = "params='place?, when?, number?, text?'"
ON = "<on><event name='Done'/></on>"
# What may surround an example of rules.
AROUND = (
    "<service address='http://a.com'>{text}</service>",
    f"<service address='http://a.com'><command name='A' {PARAMS}>"
    f"{{text}}{ON}</command></service>",
    f"<service address='http://a.com'><command name='A' {PARAMS}>"
    "<get url='/'/>{text}</command></service>",
)
SETTINGS = """<settings name="x">
  <Plugins><Plugin>HTTPService</Plugin></Plugins>
  <component name="HTTPService">
    <option name="rules" value="services/rules.xml"/>
    <option name="listen" value="127.0.0.1:8090"/>
  </component>
</settings>"""
WEBHOOK = "<webhook path='/a'><on><event name='Received'/></on></webhook>"
SCRIPT = "<dialogue><state name='A'>{}</state></dialogue>"


class Services(PageCase):
    def test_the_page_does_what_it_says(self):
        self.assertEqual(self.try_out("services.md"), 2)

    def errors(self, files):
        (self.work / "services").mkdir(exist_ok=True)
        for name, text in files.items():
            (self.work / name).write_text(text, encoding="utf-8")
        printed = self.run_commands("parlour check --json . 2>/dev/null || true")
        return [one["message"] for one in json.loads(printed)
                if one["kind"] == "error"]

    def tries(self, text):
        """The files of an application around an example."""
        if text.startswith("<request"):
            yield {"a.xml": SCRIPT.format(f"<Entrance>{text}</Entrance>"),
                   "services/rules.xml": AROUND[1].format(text="<get url='/'/>")}
            return
        if text.startswith("<handler"):
            yield {"a.xml": f"<dialogue>{text}</dialogue>",
                   "settings.xml": SETTINGS.replace(
                       "<Plugin>HTTPService</Plugin>", "").replace(
                       '"HTTPService">', '"Gateway" plugin="HTTPService">'),
                   "services/rules.xml": AROUND[0].format(text=WEBHOOK)}
            return
        if text.startswith("<component"):
            (self.work / "services").mkdir(exist_ok=True)
            for name in ("sms", "weather"):
                rules = ROOT / f"config/apps/receptionist/services/{name}.xml"
                (self.work / "services" / rules.name).write_text(
                    rules.read_text(encoding="utf-8"), encoding="utf-8")
            yield {"a.xml": SCRIPT.format(""),
                   "settings.xml": f"<settings name='x'>{text}</settings>"}
            return
        # Requests that follow each other are examples for themselves.
        parts = text.split("\n<post") if text.startswith("<post") else [text]
        examples = [parts[0], *("<post" + part for part in parts[1:])]
        for around in AROUND:
            for example in examples:
                yield {"a.xml": SCRIPT.format(""),
                       "services/rules.xml": around.format(text=example)}

    def test_examples_are_right(self):
        count = 0
        for info, text in blocks_of(PAGE):
            if info != "xml":
                continue
            with self.subTest(text=text[:60]):
                (self.work / "settings.xml").write_text(SETTINGS,
                                                        encoding="utf-8")
                said = [self.errors(files) for files in self.tries(text)]
                self.assertIn([], said)
                count += 1
        self.assertGreater(count, 9)


if __name__ == "__main__":
    unittest.main()
