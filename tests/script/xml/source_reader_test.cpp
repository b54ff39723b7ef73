#include <gmock/gmock.h>

#include "script/xml/source_reader.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

std::vector<std::string> findings_of(std::string text) {
  Findings findings;
  const auto root =
      read_source(std::move(text), findings.add_file("a.xml"), findings);
  EXPECT_EQ(findings.has_errors(), !findings.all().empty());
  EXPECT_TRUE(root || findings.has_errors());
  return test::lines_of(findings);
}

std::string only_finding_of(std::string text) {
  auto lines = findings_of(std::move(text));
  return lines.size() == 1 ? lines[0]
                           : std::to_string(lines.size()) + " findings";
}

} // namespace

TEST(SourceReader, knows_where_everything_stands) {
  const auto root =
      test::tree_of("<a>\r\n  <b one = \"1\"\n     two='&lt;2'/>\n"
                    "  <c> words </c>\n</a>");
  ASSERT_EQ(root.children.size(), 2u);
  const auto& b = root.children[0];
  EXPECT_EQ(b.position, (Position{0, 2, 3}));
  ASSERT_EQ(b.attributes.size(), 2u);
  EXPECT_EQ(b.attributes[0].position, (Position{0, 2, 6}));
  EXPECT_EQ(b.attributes[0].value_position, (Position{0, 2, 13}));
  EXPECT_EQ(b.attributes[1].position, (Position{0, 3, 6}));
  EXPECT_EQ(b.attributes[1].value, "<2");
  const auto& c = root.children[1];
  EXPECT_EQ(c.text, " words ");
  EXPECT_EQ(c.text_position, (Position{0, 4, 7}));
}

TEST(SourceReader, counts_columns_in_code_points_and_no_byte_order_mark) {
  const auto root = test::tree_of("\xef\xbb\xbf<a x='é日'><b/></a>");
  EXPECT_EQ(root.position, (Position{0, 1, 1}));
  EXPECT_EQ(root.children.at(0).position, (Position{0, 1, 11}));
}

TEST(SourceReader, joins_text_and_cdata_and_skips_comments) {
  const auto root = test::tree_of("<a>x<!-- y --><![CDATA[<z>]]></a>");
  EXPECT_EQ(root.text, "x<z>");
}

TEST(SourceReader, keeps_empty_values) {
  const auto root = test::tree_of("<a x='' y=''/>");
  ASSERT_EQ(root.attributes.size(), 2u);
  EXPECT_EQ(root.attributes[0].value_position, (Position{0, 1, 7}));
}

struct NotWellFormed {
  const char* text;
  const char* finding;
};

class SourceReaderErrors : public testing::TestWithParam<NotWellFormed> {};

TEST_P(SourceReaderErrors, are_told_with_their_place) {
  EXPECT_EQ(only_finding_of(GetParam().text), GetParam().finding);
}

INSTANTIATE_TEST_SUITE_P(
    all, SourceReaderErrors,
    testing::Values(
        NotWellFormed{"", "a.xml:1:1: error: there is no element in this file"},
        NotWellFormed{"<a>\n<b>\n</a>",
                      "a.xml:3:1: error: </a> does not fit: <b> "
                      "of line 2 is open; expected </b>"},
        NotWellFormed{"<a>\n<b></b>\n",
                      "a.xml:3:1: error: the file ends while <a> "
                      "of line 1 is open; expected </a>"},
        NotWellFormed{"<a/></b>", "a.xml:1:5: error: </b> closes nothing: no "
                                  "element is open"},
        NotWellFormed{"<a/><b/>",
                      "a.xml:1:5: error: a second root element; a file "
                      "has one"},
        NotWellFormed{"<a/>\n<![CDATA[]]>",
                      "a.xml:2:1: error: text outside of the root element"},
        NotWellFormed{"<![CDATA[x]]><a/>",
                      "a.xml:1:1: error: text outside of the root element"},
        NotWellFormed{"<a/> x", "a.xml:1:6: error: text outside of the root "
                                "element"},
        NotWellFormed{"<a/>>", "a.xml:1:5: error: text outside of the root "
                               "element"},
        NotWellFormed{"x<a>y</a>", "a.xml:1:1: error: text outside of the root "
                                   "element"},
        NotWellFormed{"<?x?><!-- y --> <a/>\n <!-- z --> x y",
                      "a.xml:2:13: error: text outside of the root element"},
        NotWellFormed{"x", "a.xml:1:1: error: there is no element in this "
                           "file"},
        NotWellFormed{"<!DOCTYPE a><a/>",
                      "a.xml:1:1: error: a DOCTYPE may not stand in a script"},
        NotWellFormed{"<x:a/>",
                      "a.xml:1:1: error: 'x:a' has a prefix; names here "
                      "have none"},
        NotWellFormed{"<a x='1' x='2'/>",
                      "a.xml:1:10: error: 'x' is given twice; leave "
                      "one of them out"},
        NotWellFormed{"<a x='1 < 2'/>",
                      "a.xml:1:9: error: '<' in a value must be "
                      "written &lt; (in an expression: lt)"},
        NotWellFormed{"<a x='b && c'/>",
                      "a.xml:1:9: error: '&&' must be written &amp;&amp; (in "
                      "an expression: and)"},
        NotWellFormed{"<a>b & c</a>",
                      "a.xml:1:6: error: '&' must be written &amp; "
                      "(in an expression: and)"},
        NotWellFormed{"<a>\xff</a>",
                      "a.xml:1:4: error: this is not UTF-8; save "
                      "the file as UTF-8"},
        NotWellFormed{"<a>\x01</a>",
                      "a.xml:1:4: error: a control character may "
                      "not stand in XML; take it out"},
        NotWellFormed{"<a>\xef\xbf\xbf</a>",
                      "a.xml:1:4: error: what stands here is no character; "
                      "take it out"},
        NotWellFormed{"<a>&#0;</a>",
                      "a.xml:1:4: error: &#0; is a character that XML does "
                      "not allow; take it out"},
        NotWellFormed{"<a><!-- </a>", "a.xml:1:4: error: this comment does not "
                                      "end; expected -->"}));

TEST(SourceReader, explains_a_bad_attribute) {
  EXPECT_THAT(only_finding_of("<a x=1/>"),
              testing::HasSubstr("a value stands in quotes: x=\"1\""));
  // Fig. 7 as printed: its quotes end the value too early.
  EXPECT_THAT(only_finding_of("<a p=\"\"select * from b\"\"/>"),
              testing::HasSubstr("ends at this \", and more follows"));
}

TEST(SourceReader, goes_on_behind_what_can_be_understood) {
  Findings findings;
  const auto root =
      read_source("<a x='1 < 2' x='&'/>", findings.add_file("a.xml"), findings);
  ASSERT_TRUE(root);
  EXPECT_EQ(root->value("x"), "1 < 2");
  EXPECT_EQ(findings.all().size(), 3u);
}

TEST(SourceReader, refuses_nesting_that_has_no_end) {
  std::string text;
  for (int i = 0; i < 100'000; ++i)
    text += "<a>";
  for (int i = 0; i < 100'000; ++i)
    text += "</a>";
  EXPECT_EQ(only_finding_of(text), "a.xml:1:601: error: elements are nested "
                                   "deeper than 200 levels");
}

TEST(SourceReader, refuses_a_file_too_large) {
  EXPECT_EQ(only_finding_of(std::string(largest_source + 1, ' ')),
            "a.xml: error: the file is larger than 16 MB");
}

TEST(SourceReader, reads_bytes_and_says_why_not) {
  test::TemporaryFolder folder;
  folder.write("a.xml", "abc");
  EXPECT_EQ(read_bytes(folder.path() / "a.xml").value(), "abc");
  EXPECT_EQ(read_bytes(folder.path() / "b.xml").error().message,
            "this file cannot be read: No such file or directory");
  EXPECT_EQ(read_bytes(folder.path()).error().message,
            "this is a folder, not a file");
}

} // namespace parlour::script
