#!/usr/bin/env python3
"""Tests the steps of docs/plugins.md outside of the tree against an installed
Parlour, and the files of `parlour plugin new` for every role. The installed
headers must not need CAF."""

import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from page_case import PROGRAM, PageCase, blocks_of, ROOT

# All plug-ins go into one program, because linking one for each takes minutes.
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(skeletons LANGUAGES CXX)
find_package(Parlour REQUIRED)
add_executable(skeletons skeletons.cpp)
target_link_libraries(skeletons PRIVATE Parlour::plugin)
target_compile_options(skeletons PRIVATE -Wall -Wextra -Wpedantic -Werror)
"""
ONE_OF_THEM = """#define parlour_plugin parlour_plugin_{role}
#include "{name}/{stem}.cpp"
#undef parlour_plugin
"""
TRY_ALL = """#include <cstdio>
#include "runtime/plugin/conformance.hpp"
int main() {{
  int count = 0;
  for (const auto* plugin : {{{plugins}}}) {{
    const auto factory = plugin->factory();
    for (const auto& wrong : parlour::conformance_errors(factory, {{}}))
      std::printf("%s: %s\\n", factory.description.name.c_str(), wrong.c_str());
    ++count;
  }}
  std::printf("%d tried\\n", count);
}}
"""

# The code around the page's short examples, in their order.
EXAMPLES = """#include "runtime/plugin/adaptors.hpp"
const parlour::OptionDescription option = %s;
parlour::Expected<void> judged(int voices) {
%s
  return {};
}
%s
class Switchboard : public parlour::RolePlugin {
  Switchboard() : RolePlugin("Telephone") {}
  void dial(const std::string&) {}
  void look_up(const std::string& name) {
%s
  }
};
"""

BUILD = PROGRAM.resolve().parents[1]


@unittest.skipUnless((BUILD / "cmake_install.cmake").exists(), "nothing built")
class PluginsTest(PageCase):
    def setUp(self):
        super().setUp()
        self.prefix = Path(self.folder.name) / "prefix"
        subprocess.run(
            ["cmake", "--install", BUILD, "--component", "plugins",
             "--prefix", self.prefix], check=True, stdout=subprocess.DEVNULL)
        self.environment["CMAKE_PREFIX_PATH"] = str(self.prefix)
        if shutil.which("ninja"):
            self.environment["CMAKE_GENERATOR"] = "Ninja"

    @unittest.skipIf("LSAN_OPTIONS" in os.environ,
                     "its programs are built without a sanitizer")
    def test_the_page_does_what_it_says(self):
        self.assertGreater(self.try_out("plugins.md"), 3)

    @unittest.skipIf("LSAN_OPTIONS" in os.environ,
                     "its program is built without a sanitizer")
    def test_what_plugin_new_writes_works_for_every_role(self):
        table = (ROOT / "runtime/message/roles.def").read_text(encoding="utf-8")
        roles = re.findall(r"^ROLE\((\w+),", table, re.M)
        self.assertGreater(len(roles), 15)
        source = ""
        for role in roles:
            name = f"New{role.capitalize()}"
            self.run_commands(f"parlour plugin new {name} --role {role}")
            source += ONE_OF_THEM.format(role=role, name=name,
                                         stem=f"new_{role.lower()}")
        source += TRY_ALL.format(plugins=", ".join(
            f"&parlour_plugin_{role}" for role in roles))
        (self.work / "CMakeLists.txt").write_text(PROJECT, encoding="utf-8")
        (self.work / "skeletons.cpp").write_text(source, encoding="utf-8")
        self.run_commands("cmake -S . -B build && cmake --build build")
        self.assertEqual(self.run_commands("build/skeletons"),
                         f"{len(roles)} tried\n")

    def test_its_plugin_is_short(self):
        page = (ROOT / "docs" / "plugins.md").read_text(encoding="utf-8")
        lines = [line for info, text in blocks_of(page)
                 for line in text.splitlines()
                 if info.endswith("=ShoutTTS/shout_tts.cpp")]
        self.assertGreater(len(lines), 20)
        self.assertLess(len(lines), 60)

    def compiles(self, text):
        source = self.work / "examples.cpp"
        source.write_text(text, encoding="utf-8")
        done = subprocess.run(
            [os.environ.get("CXX", "c++"), "-std=c++20", "-fsyntax-only",
             "-Wall", "-Wextra", "-Werror",
             "-Wno-misleading-indentation", "-I",
             self.prefix / "include" / "parlour", source],
            text=True, stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_its_short_examples_compile(self):
        page = (ROOT / "docs" / "plugins.md").read_text(encoding="utf-8")
        self.compiles(EXAMPLES % tuple(
            text for info, text in blocks_of(page) if info == "cpp"))

    def test_the_installed_headers_need_nothing_of_ours_and_no_caf(self):
        include = self.prefix / "include" / "parlour"
        headers = sorted(file.relative_to(include)
                         for file in include.rglob("*.hpp"))
        self.assertGreater(len(headers), 20)
        self.compiles(
            "".join(f'#include "{header}"\n' for header in headers) +
            "#ifdef CAF_VERSION\n#error a header includes CAF\n#endif\n")


if __name__ == "__main__":
    unittest.main()
