"""Tests what tools/cmake/test_report.py says of a log of ctest. Alone:
python3 tests/tools/cmake/test_report_test.py"""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tools/cmake"))
from test_report import report

LINE = "-" * 58

GOOD = """\
[==========] Running 2 tests from 1 test suite.
[----------] 2 tests from Lamp
[ RUN      ] Lamp.IsOn
said while it ran
[       OK ] Lamp.IsOn (0 ms)
[ RUN      ] Lamp.IsOff
[       OK ] Lamp.IsOff (0 ms)
[----------] 2 tests from Lamp (0 ms total)

[==========] 2 tests from 1 test suite ran. (0 ms total)
[  PASSED  ] 2 tests.
"""

BAD = """\
[ RUN      ] Lamp.IsOn
[       OK ] Lamp.IsOn (0 ms)
[ RUN      ] Lamp.Shines
lamp_test.cpp:7: Failure
[  FAILED  ] Lamp.Shines (0 ms)
[ RUN      ] Lamp.Needs
[  SKIPPED ] Lamp.Needs (0 ms)
[ RUN      ] Lamp.IsOff
[       OK ] Lamp.IsOff (0 ms)
[  PASSED  ] 2 tests.
[  SKIPPED ] 1 test, listed below:
[  SKIPPED ] Lamp.Needs
[  FAILED  ] 1 test, listed below:
[  FAILED  ] Lamp.Shines

 1 FAILED TEST
"""

CRASHED = """\
[ RUN      ] Lamp.IsOn
[       OK ] Lamp.IsOn (0 ms)
[ RUN      ] Lamp.Breaks
"""


def entry(name, output, verdict="Passed"):
    return (f"1/3 Testing: {name}\n1/3 Test: {name}\nCommand: \"x\"\n"
            f"Output:\n{LINE}\n{output}<end of output>\n"
            f"Test time =   0.00 sec\n{LINE}\nTest {verdict}.\n"
            f"\"{name}\" end time: now\n{LINE}\n\n")


class TestReport(unittest.TestCase):
    def said(self, *entries):
        return "\n".join(report("Start testing: now\n" + "".join(entries)))

    def test_tests_of_a_program_that_passed_are_only_counted(self):
        self.assertEqual("2 passed, 0 failed", self.said(entry("a", GOOD)))

    def test_what_failed_is_shown_without_what_passed(self):
        said = self.said(entry("a", GOOD), entry("b", BAD, "Failed"))
        self.assertIn("== b\n[ RUN      ] Lamp.Shines\nlamp_test.cpp:7", said)
        self.assertNotIn("== a", said)
        self.assertNotIn("IsOn", said)
        self.assertNotIn("IsOff", said)
        self.assertTrue(said.endswith("\n4 passed, 1 failed, 1 skipped"))

    def test_a_test_that_crashed_or_hung_is_named(self):
        said = self.said(entry("a", CRASHED, "Failed"))
        self.assertEqual("== a\n[ RUN      ] Lamp.Breaks\n\n"
                         "0 passed, 1 failed", said)

    def test_a_program_may_fail_after_its_tests(self):
        said = self.said(entry("a", GOOD, "Failed"))
        self.assertTrue(said.endswith("\n2 passed, 1 failed"))

    def test_tests_in_python_are_counted(self):
        self.assertEqual("12 passed, 0 failed", self.said(
            entry("a", f"....\n{LINE}\nRan 12 tests in 8.1s\n\nOK\n")))
        said = self.said(entry("a", f"Ran 9 tests in 1s\n\nFAILED (failures=2,"
                                    " errors=1, skipped=4)\n", "Failed"))
        self.assertTrue(said.endswith("\n2 passed, 3 failed, 4 skipped"))

    def test_any_other_program_is_one_test(self):
        said = self.said(entry("a", "7 conversations\n"), entry("b", ""),
                         entry("c", "wrong\n", "Failed"))
        self.assertEqual("== c\nwrong\n\n2 passed, 1 failed", said)


if __name__ == "__main__":
    unittest.main()
