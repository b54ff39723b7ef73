#include <vector>

#include <gtest/gtest.h>

#include "script/well_formed.hpp"

namespace parlour::script {

constexpr auto npos = std::string::npos;

TEST(WellFormed, tags_that_match_are_no_problem) {
  EXPECT_EQ(find_tag_problem("<a><b x='>'/><!-- <c> --><?p <d> ?></a>").offset,
            npos);
  EXPECT_EQ(find_tag_problem("<a><![CDATA[<b>]]></a>").offset, npos);
}

TEST(WellFormed, an_end_tag_that_does_not_fit_is_found) {
  const auto problem = find_tag_problem("<a><b></a>");
  EXPECT_EQ(problem.offset, 6u);
  EXPECT_EQ(problem.found, "a");
  EXPECT_EQ(problem.open.name, "b");
}

TEST(WellFormed, an_element_that_is_never_closed_is_found) {
  const auto problem = find_tag_problem("<a><b></b>");
  EXPECT_EQ(problem.offset, 10u);
  EXPECT_EQ(problem.found, "");
  EXPECT_EQ(problem.open.name, "a");
}

TEST(WellFormed, bare_characters_are_reported) {
  std::vector<std::size_t> offsets;
  auto note = [&](std::size_t offset, std::string) {
    offsets.push_back(offset);
  };
  check_characters("'a &amp; b &#233; &#xE9; &lt;'", 1, true, note);
  EXPECT_TRUE(offsets.empty());
  check_characters("'a & b < c &x; &#; '", 1, true, note);
  std::sort(offsets.begin(), offsets.end());
  EXPECT_EQ(offsets, (std::vector<std::size_t>{3, 7, 11, 15}));
}

} // namespace parlour::script
