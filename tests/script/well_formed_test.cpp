#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "script/well_formed.hpp"

namespace parlour::script {

TEST(WellFormed, bare_characters_are_reported) {
  std::vector<std::string> slips;
  auto note = [&](const XmlSlip& slip) {
    slips.push_back(std::to_string(slip.offset) + ": " +
                    slip.replacement.value_or("?"));
  };
  check_characters("'a &amp; b &#233; &#xE9; &lt;'", 1, true, note);
  EXPECT_TRUE(slips.empty());
  check_characters("'a & b < c &x; &#; && '", 1, true, note);
  EXPECT_EQ(slips, (std::vector<std::string>{"3: &amp;", "7: &lt;", "11: ?",
                                             "15: &amp;", "19: &amp;&amp;"}));
}

} // namespace parlour::script
