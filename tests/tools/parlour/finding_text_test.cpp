#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/parlour/finding_text.hpp"

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
  EXPECT_EQ(json[0]["severity"], "error");
  EXPECT_EQ(json[1]["severity"], "warning");
}

TEST(FindingText, prints_an_empty_array_for_nothing) {
  std::ostringstream out;
  print_json(out, {});
  EXPECT_EQ(out.str(), "[]\n");
}

} // namespace
} // namespace parlour::tools
