#include <gtest/gtest.h>

#include "adapters/nlu/parse/number_filters.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

constexpr const char* numbers = R"(
  public <room> = room for @number {Room} {act=inform} {topic=Guest};
  public <guests> = (@number {Guests}) people {act=inform} {topic=Guest};
  public <card> = [card] for @number {Card} {act=inform} {topic=Guest};)";

// What is understood of a guest, whose card has five digits.
std::string of_guest(const char* text, const char* asked = "") {
  UnderstandingModel model;
  SlotModel card{"Card", "range", {}, "", true};
  card.least = 10'000;
  card.most = 99'999;
  model.topics = {{"Guest",
                   false,
                   {{"Room", "number", {}, "", true},
                    card,
                    {"Guests", "number", {}, "", false}},
                   {}}};
  model.grammars = {{"g", numbers, {}}};
  const auto engine = NluEngine::build(model, {}, {0.4, {generic_grammar()}});
  return engine ? summary(engine->understand(text, sample_context(asked)).acts)
                : "no engine";
}

TEST(NumberFilters, LeaveOutNumbersThatCountSomething) {
  EXPECT_EQ(of_guest("room for two"), "inform Guest Room=2");
  EXPECT_EQ(of_guest("room for two hours"), "");
  EXPECT_EQ(of_guest("room for two, people"), "inform Guest Room=2");
  EXPECT_EQ(of_guest("room for six of us"), "");
  EXPECT_EQ(of_guest("room for six of those"), "inform Guest Room=6");
  EXPECT_EQ(of_guest("six people"), "inform Guest Guests=6");
}

TEST(NumberFilters, LeaveOutNumbersThatAreTooSmall) {
  EXPECT_EQ(of_guest("for 20417"), "inform Guest Card=20417");
  EXPECT_EQ(of_guest("for 2041"), "inform Guest Card=2041"); // a mistake
  EXPECT_EQ(of_guest("for six"), "");
  EXPECT_EQ(of_guest("card for six"), "inform Guest Card=6"); // is named
  EXPECT_EQ(of_guest("for six", "Guest.Card"), "~inform Guest Card=6");
}

} // namespace
} // namespace parlour::adapters::nlu::test
