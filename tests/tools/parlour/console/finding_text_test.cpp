#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/console/finding_text.hpp"

namespace parlour::tools {
namespace {

using script::Finding;
using script::Severity;

const std::vector<Finding> findings = {
    {Severity::error, {"a.xml", 3, 5}, "wrong"},
    {Severity::warning, {"b.xml", 1, 2}, "odd \"quote\" \xFF"}};

TEST(FindingText, counts) {
  EXPECT_EQ(to_string(count(findings)), "1 error, 1 warning");
  EXPECT_EQ(to_string(count({})), "0 errors, 0 warnings");
}

TEST(FindingText, prints_a_line_each) {
  std::ostringstream out;
  Places places;
  places.working = "/site";
  auto below = findings[0];
  below.place.file = "/site/app/a.xml";
  auto beside = findings[0];
  beside.place.file = "/sites/a.xml";
  print_lines(out, {findings[0], below, beside}, places);
  EXPECT_EQ(out.str(), "a.xml:3:5: error: wrong\n"
                       "app/a.xml:3:5: error: wrong\n"
                       "/sites/a.xml:3:5: error: wrong\n");
}

TEST(FindingText, prints_json_whatever_the_bytes) {
  std::ostringstream out;
  print_json(out, findings);
  const auto json = nlohmann::json::parse(out.str());
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["file"], "a.xml");
  EXPECT_EQ(json[0]["line"], 3);
  EXPECT_EQ(json[0]["column"], 5);
  EXPECT_EQ(json[0]["end"]["column"], 5);
  EXPECT_EQ(json[0]["kind"], "error");
  EXPECT_EQ(json[1]["kind"], "warning");
  EXPECT_EQ(json[0]["name"], "declaration");
  EXPECT_TRUE(json[0]["fix"].empty());
}

TEST(FindingText, prints_the_line_of_the_file) {
  test::TemporaryFolder folder;
  folder.write("a.xml", "<a>\n  <b/>\n</a>");
  std::ostringstream out;
  Places places;
  places.working = folder.path();
  const auto file = (folder.path() / "a.xml").string();
  print_lines(out, {{Severity::error, {file, 2, 3}, "wrong"}}, places);
  EXPECT_EQ(out.str(), "a.xml:2:3: error: wrong\n"
                       "    2 |   <b/>\n"
                       "      |   ^^\n");
}

TEST(FindingText, prints_corrections_as_json) {
  auto finding = findings[0];
  finding.name = "expression";
  finding.end = {"a.xml", 3, 6};
  finding.fix = {{{20, 21}, "=="}};
  std::ostringstream out;
  print_json(out, {finding});
  const auto json = nlohmann::json::parse(out.str())[0];
  EXPECT_EQ(json["name"], "expression");
  EXPECT_EQ(json["end"]["column"], 6);
  EXPECT_EQ(json["fix"][0]["begin"], 20);
  EXPECT_EQ(json["fix"][0]["end"], 21);
  EXPECT_EQ(json["fix"][0]["text"], "==");
}

TEST(FindingText, prints_an_empty_array_for_nothing) {
  std::ostringstream out;
  print_json(out, {});
  EXPECT_EQ(out.str(), "[]\n");
}

} // namespace
} // namespace parlour::tools
