// The build file, test and README of a new plug-in, as text with the names
// filled in.
#include "tools/parlour/plugin_template/plugin_skeleton.hpp"

#include <algorithm>
#include <cctype>

#include "script/source/findings.hpp"
#include "tools/parlour/plugin_template/plugin_source.hpp"

namespace parlour::tools {

namespace {

// A type name in our style: a capital, then letters, digits and underscores.
bool is_class_name(const std::string& name) {
  return !name.empty() && std::isupper(static_cast<unsigned char>(name[0])) &&
         std::ranges::all_of(
             name, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

// CMakeLists.txt: the plug-in as a file, and a test program of the same source.
std::string build_file(const std::string& name, const std::string& stem) {
  return "cmake_minimum_required(VERSION 3.25)\n"
         "project(" +
         name +
         " LANGUAGES CXX)\n"
         "\n"
         "find_package(Parlour REQUIRED)\n"
         "parlour_plugin(" +
         name + " SOURCES " + stem +
         ".cpp)\n"
         "\n"
         "enable_testing()\n"
         "add_executable(" +
         stem + "_test " + stem + "_test.cpp " + stem +
         ".cpp)\n"
         "target_link_libraries(" +
         stem +
         "_test PRIVATE Parlour::plugin)\n"
         "add_test(NAME " +
         stem + " COMMAND " + stem + "_test)\n";
}

// A test program without a test framework: the conformance test alone.
std::string test_file(const std::string& name, const std::string& role) {
  return "// " + name + " passes the conformance test of the role " + role +
         ";\n"
         "// what else it is to do is tried with a TestHost\n"
         "// (runtime/plugin/test_host.hpp).\n"
         "#include <cstdio>\n"
         "\n"
         "#include \"runtime/plugin/conformance.hpp\"\n"
         "#include \"runtime/plugin/export.hpp\"\n"
         "\n"
         "extern \"C\" const parlour::PluginLibrary parlour_plugin;\n"
         "\n"
         "int main() {\n"
         "  const auto wrong = "
         "parlour::conformance_errors(parlour_plugin.factory(), {});\n"
         "  for (const auto& sentence : wrong)\n"
         "    std::puts(sentence.c_str());\n"
         "  return wrong.empty() ? 0 : 1;\n"
         "}\n";
}

// README.md: how to build, test and install the plug-in.
std::string read_me(const std::string& name, const Role& role) {
  return "# " + name +
         "\n"
         "\n"
         "A plug-in for Parlour: role " +
         role.name + ", " + role.sentence +
         ".\n"
         "\n"
         "```sh\n"
         "cmake -S . -B build    # -DCMAKE_PREFIX_PATH=… where Parlour is "
         "installed elsewhere\n"
         "cmake --build build\n"
         "ctest --test-dir build\n"
         "parlour plugin test build/" +
         name +
         ".so\n"
         "```\n"
         "\n"
         "Copy `build/" +
         name +
         ".so` into the folder `plugins` of an "
         "application, and name it in its\n"
         "`settings.xml`: `<Plugin>" +
         name + "</Plugin>`.\n";
}

} // namespace

std::vector<std::string> component_roles() {
  std::vector<std::string> names;
  for (const auto& role : roles())
    if (!role.reserved)
      names.push_back(role.name);
  return names;
}

// Without a similar name, the error lists all roles.
Expected<const Role*> component_role(const std::string& name) {
  const auto* role = find_role(name);
  if (role && !role->reserved)
    return role;
  const auto names = component_roles();
  std::string all;
  for (const auto& one : names)
    all += (all.empty() ? "" : ", ") + one;
  const auto hint = script::did_you_mean(name, names);
  return fail(ErrorKind::settings,
              "there is no role '" + name + "'" +
                  (hint.empty() ? "; roles are " + all : hint));
}

// Files are named after the class: EchoTTS is in echo_tts.cpp.
Expected<std::vector<SkeletonFile>> plugin_skeleton(const std::string& name,
                                                    const std::string& role) {
  if (!is_class_name(name))
    return fail(ErrorKind::settings,
                "'" + name +
                    "' is no name for a plug-in: it is a class in "
                    "C++, such as EchoTTS");
  const auto found = component_role(role);
  if (!found)
    return tl::make_unexpected(found.error());
  const auto stem = snake_case(name);
  return std::vector<SkeletonFile>{
      {"CMakeLists.txt", build_file(name, stem)},
      {stem + ".cpp", plugin_source(name, **found)},
      {stem + "_test.cpp", test_file(name, (*found)->name)},
      {"README.md", read_me(name, **found)}};
}

} // namespace parlour::tools
