#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/text/edit_distance.hpp"

namespace parlour {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t longest = 8;

int distance(std::string_view left, std::string_view right) {
  return edit_distance<longest>(left, right);
}

TEST(EditDistance, counts_letters_changed_left_out_and_added) {
  EXPECT_EQ(distance("", ""), 0);
  EXPECT_EQ(distance("state", "state"), 0);
  EXPECT_EQ(distance("state", "stale"), 1);
  EXPECT_EQ(distance("state", "stte"), 1);
  EXPECT_EQ(distance("state", "sttate"), 1);
  EXPECT_EQ(distance("", "abc"), 3);
  EXPECT_EQ(distance("kitten", "sitting"), 3);
}

TEST(EditDistance, takes_neighbours_that_changed_places_as_one) {
  EXPECT_EQ(distance("avr", "var"), 1);
  EXPECT_EQ(distance("ca", "abc"), 3); // "ac" is not edited again
}

TEST(EditDistance, looks_at_the_first_letters_only) {
  EXPECT_EQ(distance("12345678abc", "12345678xyzzz"), 0);
  EXPECT_EQ(distance("1234567", "12345678xyz"), 1);
}

struct Tenths {
  using Number = float;
  static constexpr float swapped = 0.5F;
  static float change(char left, char right) {
    return left == right ? 0 : 0.3F;
  }
  static float extra(char letter, char before) {
    return letter == before ? 0.1F : 1;
  }
};

TEST(EditDistance, costs_what_it_is_told) {
  EXPECT_FLOAT_EQ((edit_distance<longest, Tenths>("cat"sv, "cut"sv)), 0.3F);
  EXPECT_FLOAT_EQ((edit_distance<longest, Tenths>("cat"sv, "catt"sv)), 0.1F);
  EXPECT_FLOAT_EQ((edit_distance<longest, Tenths>("cat"sv, "at"sv)), 1);
  EXPECT_FLOAT_EQ((edit_distance<longest, Tenths>("cat"sv, "act"sv)), 0.5F);
}

TEST(EditDistance, is_exact_up_to_what_matters_and_above_it_beyond) {
  const std::vector<std::string_view> words{"",     "cat",     "act",    "cart",
                                            "tact", "sitting", "kitten", "tac"};
  for (const auto left : words)
    for (const auto right : words) {
      const auto exact = edit_distance<longest>(left, right);
      for (int most = 0; most < 8; ++most) {
        const auto found = edit_distance<longest>(left, right, most);
        if (exact <= most)
          EXPECT_EQ(found, exact) << left << " " << right << " " << most;
        else
          EXPECT_GT(found, most) << left << " " << right;
      }
    }
}

TEST(EditDistance, is_of_any_letters) {
  EXPECT_EQ(edit_distance<longest>(u"Müller"sv, u"Muller"sv), 1);
}

} // namespace
} // namespace parlour
