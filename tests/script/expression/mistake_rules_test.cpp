#include <gtest/gtest.h>

#include "script/expression/mistake_rules.hpp"

namespace parlour::script::mistake_rules {

TEST(MistakeRules, know_nothing_of_what_they_are_not_for) {
  const Scene scene{"a b", 2, "'b' is not expected here",
                    SyntaxFault::unexpected, 'b'};
  EXPECT_FALSE(smart_quotes(scene));
  EXPECT_FALSE(apostrophe(scene));
  EXPECT_FALSE(assignment(scene));
  EXPECT_FALSE(method(scene));
  EXPECT_TRUE(missing_operator(scene));
}

TEST(MistakeRules, see_words_around_a_place) {
  EXPECT_EQ(word_end("ab cd", 0), 2u);
  EXPECT_EQ(word_end("ab cd", 2), 2u);
  EXPECT_EQ(word_begin("ab cd", 5), 3u);
  EXPECT_EQ(trimmed(" \t a b \n"), "a b");
  EXPECT_EQ(trimmed("  "), "");
}

} // namespace parlour::script::mistake_rules
