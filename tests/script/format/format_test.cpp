#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>

#include <gtest/gtest.h>

#include "script/compiler.hpp"
#include "script/format/format.hpp"
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
               "<a>\n  <!-- one\n  two -->\n  <b/> <!-- three -->\n</a>\n"},
        Layout{"<a> <!-- first -->\n<b/>\n</a>",
               "<a> <!-- first -->\n  <b/>\n</a>\n"},
        Layout{"<a>\n<!-- x --> <b/>\n</a>", "<a>\n  <!-- x --> <b/>\n</a>\n"},
        Layout{"<!-- x -->\n\n<a/>\n<!-- y -->",
               "<!-- x -->\n\n<a/>\n<!-- y -->\n"}));

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

// Every script of the tree compiles to the same program when it is formatted.
TEST(FormatSource, leaves_programs_as_they_are) {
  int files = 0;
  for (const auto* root : {"config", "tests/script/cases", "tests/fixtures"})
    for (const auto& entry :
         fs::recursive_directory_iterator(test::source_path(root))) {
      if (entry.path().extension() != ".xml")
        continue;
      std::ifstream input(entry.path(), std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(input), {}};
      Findings findings;
      const auto file = findings.add_file("a.xml", text);
      const auto before = read_source(text, file, findings);
      if (!before || findings.has_errors())
        continue;
      const auto result = format_source(text, file, findings);
      ASSERT_TRUE(result) << entry.path();
      EXPECT_EQ(formatted(*result), *result) << entry.path();
      EXPECT_TRUE(means_the_same(*before, test::tree_of(*result)));
      ++files;
    }
  EXPECT_GT(files, 100);
}

} // namespace parlour::script
