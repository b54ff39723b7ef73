"""Tests that each check of tools/check reports mistakes in a small tree and is
silent on a correct one. Alone: python3 tests/tools/check/check_test.py"""

import subprocess
import tempfile
import unittest
from pathlib import Path

CHECKS = Path(__file__).resolve().parents[3] / "tools" / "check"


class Checks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, path, text=""):
        file = Path(self.folder.name, path)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def said(self, check):
        """What the check prints; its exit code must go with it."""
        run = subprocess.run([CHECKS / check, self.folder.name],
                             capture_output=True, text=True)
        self.assertEqual("", run.stderr)
        self.assertEqual(run.returncode, 1 if run.stdout else 0)
        return run.stdout

    def includes(self, path, *included):
        self.write(path, "".join(f"#include {name}\n" for name in included))

    # layers
    def test_arrows_down_are_allowed(self):
        self.includes("actors/node/a.hpp", '"script/program/s.hpp"',
                      "<caf/all.hpp>")
        self.includes("script/program/s.hpp", '"runtime/base/b.hpp"',
                      "<string>")
        self.includes("script/program/s.cpp", "<pugixml.hpp>")
        self.includes("build/release/x.hpp", '"actors/node/a.hpp"',
                      '"nothing"')
        self.includes("tools/parlour/application/t.cpp",
                      '"adapters/network/n.hpp"')
        self.assertEqual("", self.said("layers"))

    def test_an_arrow_up_is_found(self):
        self.includes("script/program/s.hpp", "<string>", '"script/vm/a.hpp"')
        self.assertIn("script/program/s.hpp:2: script/program must not include "
                      "script/vm", self.said("layers"))

    def test_script_sees_of_the_runtime_only_its_base(self):
        self.includes("script/vm/s.hpp", '"runtime/plugin/plugin.hpp"')
        self.assertIn("script/vm must not include runtime/plugin",
                      self.said("layers"))

    def test_adapters_and_actors_do_not_know_each_other(self):
        self.includes("adapters/network/n.cpp", '"actors/node/a.hpp"')
        self.includes("actors/node/a.cpp", '"adapters/network/n.hpp"')
        said = self.said("layers")
        self.assertIn("adapters/network must not include actors/node", said)
        self.assertIn("actors/node must not include adapters/network", said)

    def test_a_ring_of_folders_is_found(self):
        self.includes("script/vm/s.hpp", '"script/program/d.hpp"')
        self.includes("script/program/d.hpp", '"script/vm/t.hpp"')
        self.assertIn("a ring of folders: script/program, script/vm",
                      self.said("layers"))

    def test_a_ring_of_units_is_found(self):
        self.includes("script/vm/a.cpp", '"script/vm/b.hpp"')
        self.includes("script/vm/b.cpp", '"script/vm/a.hpp"')
        self.assertEqual("a ring of units: script/vm/a, script/vm/b\n",
                         self.said("layers"))

    def listeners(self, folder, count):
        """A ring of `count` units, one of which calls another back."""
        def unit(i):
            return f"{folder}/u{i}.hpp"
        self.write(unit(0), "class A {\npublic:\n  class Listener {\n"
                   "    virtual void heard() = 0;\n  };\n"
                   "private:\n  Listener& listener_;\n};\n")
        for i in range(1, count):
            self.includes(unit(i), f'"{unit(i - 1)}"')
        self.write(unit(count), f'#include "{unit(count - 1)}"\n'
                   "class B final : public Other, private A::Listener {};\n")

    def test_a_ring_by_callbacks_is_found(self):
        self.listeners("script/vm", 2)
        self.assertEqual("", self.said("layers"))
        self.listeners("script/vm", 3)
        said = self.said("layers")
        self.assertIn("script/vm: a ring of 4 units by callbacks, at most 3: "
                      "script/vm/u0, script/vm/u1, script/vm/u2, script/vm/u3",
                      said)

    def test_who_only_derives_is_no_ring(self):
        self.listeners("script/vm", 3)
        self.write("script/vm/u0.hpp",
                   "class A { virtual void heard() = 0; };\n")
        self.assertEqual("", self.said("layers"))

    def test_a_reference_that_is_lent_is_no_arrow(self):
        self.write("script/vm/machine.hpp",
                   "class Host {\n  virtual void run() = 0;\n};\n"
                   "class Machine {\n  Host* host_;\n};\n")
        for i in range(3):
            self.includes(f"script/vm/u{i}.hpp",
                          f'"script/vm/u{i - 1}.hpp"' if i else
                          '"script/vm/machine.hpp"')
        self.write("script/vm/u3.hpp", '#include "script/vm/u2.hpp"\n'
                   "class Effects final : public Host {};\n")
        self.assertEqual("", self.said("layers"))
        self.write("script/vm/machine.hpp", "class Machine {};\n")
        self.assertEqual("script/vm/machine: no field refers to Host; strike "
                         "it from NO_ARROW\n", self.said("layers"))

    def test_code_in_no_room_is_found(self):
        self.includes("script/s.hpp", "<string>")
        self.includes("elsewhere/s.hpp", "<string>")
        self.assertEqual(
            "script/s.hpp: stands in no room of tools/check/layers\n",
            self.said("layers"))

    def test_libraries_stay_where_they_belong(self):
        self.includes("script/vm/s.cpp", "<caf/all.hpp>")
        self.includes("runtime/base/b.cpp", "<caf/all.hpp>")
        self.includes("script/vm/x.hpp", "<pugixml.hpp>", "<unicode/uchar.h>")
        self.assertEqual(4, len(self.said("layers").splitlines()))

    def test_includes_are_named_from_the_root(self):
        self.includes("script/vm/s.cpp", '"s.hpp"')
        self.assertIn("not named from the root", self.said("layers"))

    # sizes
    def test_a_long_function_is_found(self):
        lines = "  work(\"}\");  // {\n" * 58
        self.write("script/s.cpp",
                   "namespace n {\nint X::good() const {\n" + lines + "}\n"
                   "X::X(int a)\n    : a_{a}, b_() {\n" + lines + "}\n}\n")
        self.assertEqual("script/s.cpp:62: X::X has 61 lines, 60 at most\n",
                         self.said("sizes"))

    def test_a_long_class_is_no_long_function(self):
        self.write("script/s.hpp", "class A {\n" + "int f() { return 1; }\n"
                   * 99 + "};\n")
        self.assertEqual("", self.said("sizes"))

    def test_a_long_file_is_found(self):
        self.write("script/s.cpp", "int x;\n" * 401)
        self.assertIn("401 lines", self.said("sizes"))

    # tests
    def test_a_source_without_its_test_is_found(self):
        self.write("script/a.cpp")
        self.write("script/b.cpp")
        self.write("tools/parlour/main.cpp")
        self.write("tests/script/b_test.cpp")
        said = self.said("tests")
        self.assertEqual("script/a.cpp: no tests/script/a_test.cpp\n", said)

    def test_a_part_of_another_source_is_tested_with_it(self):
        self.write("script/whole.hpp")
        self.includes("script/part.cpp", '"script/whole.hpp"')
        self.assertIn("script/part.cpp", self.said("tests"))
        self.write("tests/script/whole_test.cpp")
        self.assertEqual("", self.said("tests"))
        self.write("script/part.hpp")
        self.assertIn("script/part.cpp", self.said("tests"))

    # readmes
    def test_a_folder_without_a_sign_is_found(self):
        self.write("script/README.md", "x\n" * 30)
        self.write("script/dialogue/d.cpp")
        self.assertEqual("script/dialogue: no README.md\n",
                         self.said("readmes"))

    def test_a_sign_is_short(self):
        self.write("script/README.md", "x\n" * 31)
        self.assertIn("over 30 lines", self.said("readmes"))

    # words
    # saved
    def part(self, listed, fields):
        self.write("script/part.hpp", "class Part {\npublic:\n"
                   "  template <class Archive>\n"
                   "  void serialize(Archive& archive) {\n"
                   "    archive(" + listed + ");\n  }\n"
                   "  int told() const {\n    return 1;\n  }\n\n"
                   "private:\n  struct Inner {\n    int deep = 0;\n  };\n"
                   + fields + "};\n")
        return self.said("saved")

    def test_fields_that_are_listed_are_saved(self):
        self.assertEqual("", self.part(
            "port_, all_, last_, known_",
            "  Port& port_;\n  std::map<int, Inner> all_; // by id\n"
            "  bool last_ = false;\n  std::vector<Inner> known_{Inner{}};\n"))

    def test_a_field_that_is_forgotten_is_found(self):
        said = self.part("all_", "  std::vector<int> all_;\n"
                         "  bool a = false;\n  Milliseconds b{0};\n"
                         "  struct Of {\n    int x;\n  } c;\n"
                         "  std::vector<std::pair<int, int>> d; // of these\n")
        for name in "abcd":
            self.assertIn(f"Part::{name} is not saved", said)
        self.assertNotIn("all_", said)

    def test_a_path_of_somebody_is_found(self):
        self.write("script/s.cpp", "// see /" + "work/x, not net/work\n")
        self.assertEqual(1, len(self.said("words").splitlines()))

    # citations; split, as they are none of this file's
    def write_rules(self):
        self.write("docs/engine.md", "# The engine\n\n## 1. A way\n\n"
                   "* **1a** It is stamped.\n\n### 1.1 The centre\n")
        self.write("script/LANGUAGE.md", "## 4. Text\n\n**4.4** In text.\n")

    def test_what_is_there_may_be_cited(self):
        self.write_rules()
        self.write("docs/understanding.md", "## Score\n")
        self.write("script/README.md", "[a](../docs/engine.md#11-the-centre)\n"
                   "[b](https://example.org) `[c](nowhere)`\n"
                   "```\n[d](nowhere)\n```\n[e](LANGUAGE.md)\n")
        self.write("script/s.hpp", "// One (engine\n"
                   "  // rules 1a, 1 and 1.1; engine rule 1, \"The\n// centre\";"
                   " LANGUAGE.md; docs/engine.md; understanding,\n"
                   '// "Score").\nauto rule = "engine rule 9";\n')
        self.assertEqual("", self.said("citations"))

    def test_a_rule_that_is_not_there_is_found(self):
        self.write_rules()
        self.write("script/s.hpp", "int a; // (engine\n// rules 1a and 1c)\n")
        self.write("tests/t.py", "# language rule" + " 4.5\n")
        self.write("config/c.xml", "<!-- engine rule" + ' 1, "Lanes" -->\n')
        self.assertEqual('config/c.xml:1: engine rule 1 has no "Lanes"\n'
                         "script/s.hpp:1: there is no engine rule 1c\n"
                         "tests/t.py:1: there is no language rule 4.5\n",
                         self.said("citations"))

    def test_a_rule_of_its_own_page_needs_no_name(self):
        self.write("script/LANGUAGE.md", "**4.4** Braces (rule 4.5).\n")
        self.assertIn("LANGUAGE.md:1: there is no language rule" + " 4.5",
                      self.said("citations"))

    def test_a_page_or_section_that_is_not_there_is_found(self):
        self.write_rules()
        self.write("script/s.hpp", "// session" + '.md, "Seats"\n'
                   "// engine" + '.md, "Seats"\n')
        self.assertEqual("script/s.hpp:1: there is no page session.md\n"
                         'script/s.hpp:2: engine.md has no section "Seats"\n',
                         self.said("citations"))

    def test_a_link_that_leads_nowhere_is_found(self):
        self.write_rules()
        self.write("README.md", "[a](docs/engine.md#lanes)\n"
                   "![b](docs/house.svg)\n[c](#here)\n")
        self.assertEqual(3, len(self.said("citations").splitlines()))


if __name__ == "__main__":
    unittest.main()
