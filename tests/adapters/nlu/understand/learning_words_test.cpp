#include <gmock/gmock.h>

#include "adapters/nlu/understand/learning_words.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

using testing::ElementsAre;

// The words of a text; those of a known value are in brackets.
std::vector<std::string> words_of(const std::string& text) {
  Stages stages("public <x> = @Appointment.Host | @time;", text);
  std::vector<std::string> made;
  for (const auto& word :
       learning_words(stages.utterance, stages.spans, nullptr))
    made.push_back(word.kind == 0 ? std::string(word.word)
                                  : '[' + std::string(word.word) + ']');
  return made;
}

TEST(LearningWords, HaveTheKindsOfKnownValues) {
  EXPECT_THAT(words_of("see Priya Nair at 9:30"),
              ElementsAre("see", "[priya]", "[nair]", "at", "[9:30]"));
}

TEST(LearningWords, WhatOnlySoundsLikeAValueIsNone) {
  EXPECT_THAT(words_of("see a pryer"), ElementsAre("see", "a", "pryer"));
}

TEST(LearningWords, AreATextWithoutFillers) {
  Stages stages("public <x> = @time;", "er see me at nine");
  EXPECT_EQ(text_of(learning_words(stages.utterance, stages.spans, nullptr)),
            "see me at nine");
}

} // namespace
} // namespace parlour::adapters::nlu::test
