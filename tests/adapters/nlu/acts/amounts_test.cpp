#include <gtest/gtest.h>

#include "adapters/nlu/acts/amounts.hpp"

namespace parlour::adapters::nlu {
namespace {

// The amount before the last word: "2", "1 more", "" where none is said.
std::string before_last(const char* text) {
  const auto tokens = tokenize(text);
  const auto amount = amount_before(tokens, tokens.list.size() - 1);
  return (amount.number ? std::to_string(*amount.number) : "") +
         (amount.more ? " more" : "");
}

TEST(Amounts, AreReadBackwardsFromTheValue) {
  struct {
    const char* text;
    const char* expected;
  } const cases[] = {
      {"coffee", ""},
      {"the coffee", ""},
      {"a coffee", "1"},
      {"two coffees", "2"},
      {"I would like 12 coffees", "12"},
      {"twenty five coffees", "25"},
      {"a dozen eggs", "12"},
      {"a couple of coffees", "2"},
      {"two cups of coffee", "2"},
      {"a glass of water", "1"},
      {"a couple of slices of cake", "2"},
      {"another coffee", "1 more"},
      {"two more coffees", "2 more"},
      {"one extra coffee", "1 more"},
      {"more coffee", " more"},
      {"another glass of water", "1 more"},
      {"take one of the burgers", "1"},
      {"two of my eggs", "2"},
      {"2 of your eggs", "2"},
      {"one of the two eggs", "1"},
      {"a couple of the eggs", "2"},
      {"the two eggs", "2"},
      {"some of the eggs", ""},
      // what belongs to something else
      {"room two, coffee", ""},
      {"the second coffee", ""},
      {"two teas and coffee", ""},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(before_last(text), expected) << text;
}

TEST(Amounts, AreNotWhatIsSaidOfSomethingElse) {
  const auto tokens = tokenize("room 204 two coffees");
  EXPECT_EQ(amount_before(tokens, 2, 2).number, std::nullopt);
  EXPECT_EQ(amount_before(tokens, 3, 2).number, 2);
}

} // namespace
} // namespace parlour::adapters::nlu
