#include <gtest/gtest.h>

#include "adapters/nlu/acts/courtesies.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

const char* const grammar = "public <hello> = good morning {act=greet};"
                            "public <yes> = okay {act=confirm};"
                            "public <no> = no {act=deny};";

// The words that are left.
std::string without(const std::string& said, bool generic = true,
                    const Value& where = {}) {
  const Stages stages(grammar, said, where, generic);
  const auto chains =
      best_chains(stages.islands, stages.utterance.size(), stages.context);
  const auto plain =
      without_courtesies(stages.utterance, chains.at(0), stages.context);
  std::string left;
  for (std::size_t at = 0; at < plain.size(); ++at) {
    EXPECT_TRUE(!plain.filler[at] || plain.weight[at] == 0);
    if (!plain.filler[at])
      left.append(left.empty() ? "" : " ").append(plain.tokens.list[at].word);
  }
  return left;
}

TEST(Courtesies, AreLeftOut) {
  EXPECT_EQ(without("Good morning, my screen is dark"), "my screen is dark");
  EXPECT_EQ(without("my screen is dark, good morning"), "my screen is dark");
  EXPECT_EQ(without("good morning"), "");
}

TEST(Courtesies, AnAnswerIsNone) {
  EXPECT_EQ(without("No, my screen is dark"), "no my screen is dark");
  EXPECT_EQ(without("Okay, my screen is dark"), "my screen is dark");
  EXPECT_EQ(without("Okay, my screen is dark", true,
                    Value(Map{{"confirms", "Shall I?"}})),
            "okay my screen is dark");
}

// What an application calls a greeting may be what it is about.
TEST(Courtesies, AreThePlatforms) {
  EXPECT_EQ(without("Good morning, my screen is dark", false),
            "good morning my screen is dark");
}

TEST(Courtesies, WhichActsAreSo) {
  EXPECT_TRUE(is_courtesy("thank"));
  EXPECT_FALSE(is_courtesy("confirm"));
  EXPECT_FALSE(is_courtesy("bye"));
  const Automaton automaton;
  const auto opens = [&](const char* said, const char* act, std::uint32_t begin,
                         const Context& context = {}) {
    return is_opening(act, begin, make_utterance(said, automaton), context);
  };
  EXPECT_TRUE(opens("hello there", "greet", 0));
  EXPECT_FALSE(opens("hello there", "help", 0));
  EXPECT_TRUE(opens("well okay then", "confirm", 1));
  EXPECT_TRUE(opens("that is it. okay then", "confirm", 3));
  EXPECT_FALSE(opens("is it open right now", "confirm", 3));
  EXPECT_FALSE(opens("yes it is", "confirm", 0));
  Context asks;
  asks.asked_topic = 0;
  EXPECT_FALSE(opens("okay then", "confirm", 0, asks));
}

TEST(Courtesies, WhatJoinsASentenceIsLeftOut) {
  EXPECT_EQ(without("And also my screen is dark"), "my screen is dark");
  EXPECT_EQ(without("Good morning, but my screen is dark"),
            "my screen is dark");
  EXPECT_EQ(without("And in the bedroom"), "and in the bedroom");
}

} // namespace
} // namespace parlour::adapters::nlu::test
