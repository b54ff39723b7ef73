#include <gtest/gtest.h>

#include "adapters/nlu/acts/correction.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

UnderstandingModel tables() {
  UnderstandingModel model;
  model.topics = {
      {"Table",
       false,
       {{"Guests", "number", {}, "", true, false},
        {"Name", "", {}, "", true, false},
        {"Place", "set", {"window", "garden", "bar"}, "", true, false},
        {"When", "time", {}, "", true, false},
        {"Chairs", "number", {}, "", true, false}},
       {"I want a table"}}};
  return model;
}

std::string understood(const char* asked, List said, const char* text) {
  static const auto built =
      NluEngine::build(tables(), sample_column, {0.4, {generic_grammar()}});
  auto context = *sample_context(std::string("Table.") + asked).if_map();
  context.set("said", std::move(said));
  return summary(built->understand(text, context).acts);
}

TEST(Correction, IsOfWhatWasSaidBefore) {
  struct {
    const char* asked;
    List said;
    const char* text;
    const char* expected;
  } const cases[] = {
      // the other reading of the same words
      {"Chairs", {"Guests"}, "no, I meant three", "~correct Table Guests=3"},
      {"When", {"Guests"}, "no, I meant three", "~correct Table Guests=3"},
      {"When", {"Guests"}, "three", "~inform Table When=15:00"},
      // what does not fit there is of what is asked
      {"Chairs", {"When"}, "no, at 7pm", "~correct Table When=19:00"},
      {"Chairs", {"Place"}, "no, I meant three", "~correct Table Chairs=3"},
      {"Chairs", {}, "no, I meant three", "~correct Table Chairs=3"},
      // the last that it fits
      {"Chairs",
       {"Guests", "When"},
       "I mean three",
       "~correct Table When=15:00"},
      {"Chairs", {"When", "Guests"}, "I mean three", "~correct Table Guests=3"},
      // any words fit a slot of any words, but not better than what is asked
      {"When", {"Name"}, "no, I meant 7pm", "~correct Table When=19:00"},
      {"Place", {"Name"}, "no, I meant Hannah", "~correct Table Name=Hannah"},
  };
  for (const auto& [asked, said, text, expected] : cases)
    EXPECT_EQ(understood(asked, said, text), expected) << asked << ": " << text;
}

TEST(Correction, InTheSameBreathIsPartOfWhatIsSaid) {
  struct {
    const char* text;
    const char* expected;
  } const cases[] = {
      {"at 7pm. Sorry, I mean the garden",
       "~inform Table When=19:00 Place=garden"},
      {"at 7pm. Sorry, I mean at 8pm", "~inform Table When=20:00"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(understood("When", {}, text), expected) << text;
}

} // namespace
} // namespace parlour::adapters::nlu::test
