#include <gtest/gtest.h>

#include "adapters/nlu/acts/denied_values.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// Topics whose thing may be said several times.
std::string understood(const std::string& text, const std::string& asked = "") {
  UnderstandingModel model;
  model.topics = {
      {"Supplies",
       false,
       {{"Thing", "set", {"towels", "pillow", "soap"}, "", true, false, true},
        {"Room", "number", {}, "", true, false}},
       {"I need more [towels](Thing)"}}};
  model.grammars = {
      {"supplies",
       R"(public <need> = [(we | i) need] [any | one more] @Supplies.Thing
            [[please | only | or | and] [one more] @Supplies.Thing] [in @number {Room}]
            {topic=Supplies} {act=inform};)",
       {"supplies.jsgf", 1, 1}}};
  static const auto built =
      NluEngine::build(model, {}, {0.4, {generic_grammar()}});
  std::string line;
  for (const auto& act : built->understand(text, sample_context(asked)).acts) {
    line += (line.empty() ? "" : " + ") + act["act"].text();
    if (const auto* items = act["slots"]["Thing"]["items"].if_list())
      for (const auto& item : *items)
        line += " " + item["value"].text();
  }
  return line;
}

TEST(DeniedValues, AreThoseRightBehindANo) {
  EXPECT_EQ(understood("No towels please, one more pillow in 108"),
            "inform pillow");
  EXPECT_EQ(understood("No towels please, one more pillow", "Supplies"),
            "deny towels + inform pillow");
  EXPECT_EQ(understood("no towels or soap", "Supplies"), "deny towels soap");
  EXPECT_EQ(understood("no, towels", "Supplies"), "correct towels");
  EXPECT_EQ(understood("we have no towels"), "correct towels");
}

TEST(DeniedValues, EndWhereSomethingIsWanted) {
  EXPECT_EQ(understood("we don't need any towels, only one more pillow"),
            "inform pillow");
  EXPECT_EQ(understood("we don't need any towels or soap"), "deny");
}

TEST(DeniedValues, AreNoneBehindASentenceThatDenies) {
  EXPECT_EQ(understood("Of course she isn't. Towels?", "Supplies"),
            understood("Towels?", "Supplies"));
  EXPECT_EQ(understood("not towels", "Supplies"), "deny towels");
}

} // namespace
} // namespace parlour::adapters::nlu::test
