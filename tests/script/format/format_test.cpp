#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <ostream>
#include <regex>

#include <gtest/gtest.h>

#include "script/compiler/compiler.hpp"
#include "script/format/format.hpp"
#include "script/lint/lint.hpp"
#include "script/values/objects.hpp"
#include "script/vm/program_identity.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

namespace fs = std::filesystem;

std::string formatted(const std::string& text) {
  Findings findings;
  auto result = format_source(text, findings.add_file("a.xml", text), findings);
  return result.value_or("-");
}

struct Layout {
  const char* written;
  const char* laid_out;
};

void PrintTo(const Layout& layout, std::ostream* stream) {
  *stream << layout.written;
}

} // namespace

class FormatLayout : public testing::TestWithParam<Layout> {};

TEST_P(FormatLayout, lays_out_once_and_for_all) {
  const auto result = formatted(GetParam().written);
  EXPECT_EQ(result, GetParam().laid_out);
  EXPECT_EQ(formatted(result), result);
}

INSTANTIATE_TEST_SUITE_P(
    lines, FormatLayout,
    testing::Values(
        Layout{"<a>\n<b/>\n      <c/></a>", "<a>\n  <b/>\n  <c/>\n</a>\n"},
        Layout{"<a><b/> <c/></a>", "<a><b/><c/></a>\n"},
        Layout{"<a>\n\n\n<b/>\n\n\n<c/>\n\n</a>\n\n",
               "<a>\n  <b/>\n\n  <c/>\n</a>\n"},
        Layout{"<dialogue></dialogue>", "<dialogue/>\n"},
        Layout{"<a\n  x = '1'\n  y=\"2\" />", "<a x='1' y=\"2\"/>\n"},
        Layout{"<?xml version='1.0'?><a/>", "<?xml version='1.0'?>\n<a/>\n"},
        Layout{"<a>\r\n<b/>\r\n</a>\r\n", "<a>\r\n  <b/>\r\n</a>\r\n"},
        Layout{"\xef\xbb\xbf<a/>", "\xef\xbb\xbf<a/>\n"}));

INSTANTIATE_TEST_SUITE_P(
    comments, FormatLayout,
    testing::Values(
        Layout{"<a>\n<!-- one\n  two -->\n<b/>   <!-- three -->\n</a>",
               "<a>\n  <!-- one\n  two -->\n  <b/>   <!-- three -->\n</a>\n"},
        Layout{"<a> <!-- first -->\n<b/>\n</a>",
               "<a> <!-- first -->\n  <b/>\n</a>\n"},
        Layout{"<a>\n<!-- x --> <b/>\n</a>", "<a>\n  <!-- x --> <b/>\n</a>\n"},
        Layout{"<!-- x -->\n\n<a/>\n<!-- y -->",
               "<!-- x -->\n\n<a/>\n<!-- y -->\n"}));

// What a comment allows stays where the comment is.
INSTANTIATE_TEST_SUITE_P(
    allowances, FormatLayout,
    testing::Values(
        Layout{"<function name='f'>\n"
               "<try><print param='one one one one'/><print param='two two "
               "two'/></try> <!-- check: allow catchless-try -->\n</function>",
               "<function name='f'>\n"
               "  <try><print param='one one one one'/><print param='two two "
               "two'/></try> <!-- check: allow catchless-try -->\n"
               "</function>\n"},
        Layout{"<function name='f'><var name='x'/><var name='y'/> <!-- check: "
               "allow unread-variable -->\n</function>",
               "<function name='f'> <var name='x'/> <var name='y'/> <!-- "
               "check: allow unread-variable -->\n</function>\n"},
        Layout{"<a>\n<!-- check: allow one -->\n<b/><c/>\n<d/></a> <!-- "
               "check: allow two -->",
               "<a>\n  <!-- check: allow one -->\n  <b/> <c/>\n  <d/></a> "
               "<!-- check: allow two -->\n"}));

INSTANTIATE_TEST_SUITE_P(
    texts, FormatLayout,
    testing::Values(
        Layout{"<phrases>\n<phrase act='help'>  two\n   lines </phrase>\n"
               "</phrases>",
               "<phrases>\n  <phrase act='help'>  two\n   lines </phrase>\n"
               "</phrases>\n"},
        Layout{"<phrase act='x'> </phrase>", "<phrase act='x'> </phrase>\n"},
        Layout{"<grammar name='g'><![CDATA[\n <x> ]]></grammar>",
               "<grammar name='g'><![CDATA[\n <x> ]]></grammar>\n"},
        Layout{"<a x='1 &lt; 2\n  3'/>", "<a x='1 &lt; 2\n  3'/>\n"}));

INSTANTIATE_TEST_SUITE_P(
    wide, FormatLayout,
    testing::Values(
        Layout{"<sessions resume-after=\"2s\" no-input-after=\"8s\" "
               "context-for=\"2m\" request-timeout=\"10s\"/>",
               "<sessions resume-after=\"2s\" no-input-after=\"8s\" "
               "context-for=\"2m\"\n          request-timeout=\"10s\"/>\n"},
        Layout{"<if cond=\"true\"><print param=\"one\"/><print "
               "param=\"two\"/><print param=\"three three\"/></if>",
               "<if cond=\"true\">\n  <print param=\"one\"/>\n"
               "  <print param=\"two\"/>\n  <print param=\"three "
               "three\"/>\n</if>\n"}));

TEST(FormatSource, tells_why_a_text_cannot_be_formatted) {
  Findings findings;
  const std::string text = "<a><b></a>";
  EXPECT_FALSE(format_source(text, findings.add_file("a.xml", text), findings));
  EXPECT_EQ(findings.all().size(), 1u);
}

TEST(FormatSource, compares_meaning) {
  const auto tree = test::tree_of("<a x='1'><b>t</b></a>");
  EXPECT_TRUE(means_the_same(tree, test::tree_of("<a x=\"1\">\n<b>t</b></a>")));
  for (const auto* other :
       {"<a x='2'><b>t</b></a>", "<a><b>t</b></a>", "<a x='1'><b>u</b></a>",
        "<a x='1'/>", "<a x='1'><c>t</c></a>"})
    EXPECT_FALSE(means_the_same(tree, test::tree_of(other))) << other;
}

namespace {

std::string text_of(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

std::vector<fs::path> scripts_below(std::initializer_list<const char*> roots) {
  std::vector<fs::path> files;
  for (const auto* root : roots)
    for (const auto& entry :
         fs::recursive_directory_iterator(test::source_path(root)))
      if (entry.path().extension() == ".xml")
        files.push_back(entry.path());
  return files;
}

// What the compiler and the lint say, places aside, and the program's identity
// as if all of it stood in one place.
std::string compiled(const std::string& text) {
  test::TemporaryFolder folder;
  folder.write("a.xml", text);
  auto result = compile_file(folder.path() / "a.xml", test::platform());
  std::vector<std::string> said;
  lint::lint(result, {});
  for (const auto& finding : result.findings.all())
    said.push_back(finding.name + ": " + finding.message);
  std::sort(said.begin(), said.end());
  std::string all;
  for (const auto& one : said)
    all += std::regex_replace(one, std::regex("line [0-9]+"), "line") + '\n';
  if (!result.program)
    return all;
  auto program = *result.program;
  for (auto& code : program.code)
    for (auto& position : code.positions)
      position = {};
  program.pool->identity = 0;
  return all + std::to_string(identity_of(program));
}

} // namespace

// Every script of the tree means the same when it is formatted, and formatting
// it again changes nothing.
TEST(FormatSource, leaves_programs_as_they_are) {
  int files = 0;
  for (const auto& path : scripts_below(
           {"config", "tests/script/cases", "tests/script/dialogue/plays",
            "tests/script/mistakes", "tests/fixtures"})) {
    const auto text = text_of(path);
    const auto result = formatted(text);
    if (result == "-")
      continue; // not well-formed
    EXPECT_EQ(formatted(result), result) << path;
    EXPECT_EQ(compiled(text), compiled(result)) << path;
    ++files;
  }
  EXPECT_GT(files, 300);
}

TEST(FormatSource, has_laid_out_what_is_shipped) {
  for (const auto& path :
       scripts_below({"config", "tests/tools/parlour/applications"})) {
    const auto text = text_of(path);
    EXPECT_EQ(formatted(text), text) << path;
  }
}

} // namespace parlour::script
