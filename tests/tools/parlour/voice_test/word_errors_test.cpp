#include <gtest/gtest.h>

#include "tools/parlour/voice_test/word_errors.hpp"

namespace parlour::tools {
namespace {

WordErrors errors(std::size_t words, std::size_t substitutions,
                  std::size_t insertions, std::size_t deletions) {
  return {words, substitutions, insertions, deletions};
}

TEST(WordErrors, are_counted_by_kind) {
  EXPECT_EQ(count_word_errors("is it open now", "is it open now"),
            errors(4, 0, 0, 0));
  EXPECT_EQ(count_word_errors("is it open now", "is it opened now"),
            errors(4, 1, 0, 0));
  EXPECT_EQ(count_word_errors("is it open now", "is it uh open now then"),
            errors(4, 0, 2, 0));
  EXPECT_EQ(count_word_errors("is it open now", "it now"), errors(4, 0, 0, 2));
}

TEST(WordErrors, of_nothing) {
  EXPECT_EQ(count_word_errors("is it open", ""), errors(3, 0, 0, 3));
  EXPECT_EQ(count_word_errors("", "oh"), errors(0, 0, 1, 0));
  EXPECT_EQ(count_word_errors("", "oh").rate(), 0);
}

TEST(WordErrors, compare_what_is_spoken) {
  EXPECT_EQ(count_word_errors("Dr. Ho, at 10:30am!", "doctor ho at ten thirty "
                                                     "am"),
            errors(6, 0, 0, 0));
}

TEST(WordErrors, are_added_up) {
  auto sum = errors(4, 1, 0, 0);
  sum += errors(6, 0, 1, 2);
  EXPECT_EQ(sum, errors(10, 1, 1, 2));
  EXPECT_EQ(sum.errors(), 4u);
  EXPECT_EQ(sum.rate(), 40);
}

} // namespace
} // namespace parlour::tools
