#include <gtest/gtest.h>

#include "adapters/nlu/text/negation.hpp"

namespace parlour::adapters::nlu {
namespace {

bool negates(const char* text) {
  const auto tokens = tokenize(text);
  const auto found = negations(tokens);
  return std::find(found.begin(), found.end(), true) != found.end();
}

bool is_order(const char* text) {
  const auto tokens = tokenize(text);
  return is_negated_order(tokens, negations(tokens));
}

TEST(Negation, TurnsOrdersRound) {
  for (const auto* text :
       {"do not open the door", "don't open the door", "Please don't open it",
        "never open the door", "you must not open it",
        "I don't want to open it", "you shouldn't open the door",
        "don't you dare open the door", "the light is not on",
        "please do not ever open it"})
    EXPECT_TRUE(negates(text)) << text;
}

TEST(Negation, AShortLastSentenceWithoutSomethingIsAnOrder) {
  for (const auto* text :
       {"no taxi then", "She is picking me up. No taxi, thanks.",
        "no wake-up call please"})
    EXPECT_TRUE(is_order(text)) << text;
  for (const auto* text :
       {"no", "no, a taxi", "No taxi. I walk.", "I have no umbrella",
        "no idea where to go from here now", "no hurry", "no hot water",
        "The alarm went off. No burglar.", "no one told me"})
    EXPECT_FALSE(is_order(text)) << text;
}

TEST(Negation, WhatNeverHappenedIsToldAndNotOrdered) {
  EXPECT_FALSE(is_order("I sent my CV and never heard back"));
  EXPECT_FALSE(is_order("never received it"));
  for (const auto* text : {"please never open it", "okay never open the door",
                           "we will never need a taxi again"})
    EXPECT_TRUE(is_order(text)) << text;
}

TEST(Negation, AsksAndTellsWithoutIt) {
  for (const auto* text :
       {"why not open the door", "isn't there a bank", "can't I open the door",
        "don't you have a bank here", "I could not find the bank",
        "I didn't find it", "it does not work", "never mind", "no, open it",
        "I have never been here"})
    EXPECT_FALSE(negates(text)) << text;
}

TEST(Negation, AnOrderAsAWhole) {
  for (const auto* text :
       {"please don't launch the rocket", "do not launch it",
        "never launch the rocket", "I do not want to launch the rocket",
        "you should not launch it"})
    EXPECT_TRUE(is_order(text)) << text;
  for (const auto* text :
       {"launch the rocket", "don't forget to launch the rocket",
        "do not hesitate to launch", "I do not know how to launch it",
        "I don't have a ticket", "I don't care, launch it",
        "my card is not working", "please don't"})
    EXPECT_FALSE(is_order(text)) << text;
}

TEST(Negation, AWarningIsNoOrder) {
  for (const auto* text :
       {"don't spill it", "don't be late", "don't ask me why",
        "don't tell me it is closed", "you don't happen to know the way",
        "I don't drink coffee", "people don't launch it here"})
    EXPECT_FALSE(is_order(text)) << text;
  for (const auto* text :
       {"we don't want it", "I don't need the rocket", "don't tell her",
        "don't ask him", "it must not be turned on", "it should not be moved"})
    EXPECT_TRUE(is_order(text)) << text;
}

TEST(Negation, WhatNobodyAskedForIsNotOrdered) {
  for (const auto* text :
       {"I didn't ask you to launch it", "I never told you to launch it",
        "nobody asked you to launch it"})
    EXPECT_TRUE(is_order(text)) << text;
  EXPECT_TRUE(is_order("no one told you to launch it"));
  EXPECT_FALSE(is_order("did nobody tell you to launch it"));
  for (const auto* text : {"did I not ask you to launch it", "who asked you",
                           "I asked you to launch it"})
    EXPECT_FALSE(is_order(text)) << text;
}

TEST(Negation, IsSaidInOtherWords) {
  for (const auto* text : {"no need to open the door", "stop opening the door",
                           "please stop ringing", "avoid opening the door",
                           "I forbid you to open it",
                           "nobody may open the door", "no one must open it"})
    EXPECT_TRUE(is_order(text)) << text;
  for (const auto* text :
       {"I need to open the door", "stop the spring", "where is the bus stop",
        "when do you stop serving breakfast", "it will not stop raining",
        "how can I avoid the queue", "no one can open it, please open it",
        "nobody is at the door"})
    EXPECT_FALSE(is_order(text)) << text;
}

TEST(Negation, SomethingIsCalledOff) {
  for (const auto* text :
       {"cancel my table", "I want to cancel it", "can we call it off",
        "call off the meeting", "call that meeting off please",
        "If not, fine. Cancel it."})
    EXPECT_TRUE(calls_off(tokenize(text))) << text;
  for (const auto* text :
       {"what if I cancel it", "when can I cancel", "was it cancelled",
        "how do I cancel it", "do you charge me if I cancel",
        "I did not cancel", "why did you cancel it", "a noise cancelling robot",
        "call Tom off the list", "I call it a rip off", "call Tom",
        "I call when the light is off", "it is off, call me",
        "call me. Lights off."})
    EXPECT_FALSE(calls_off(tokenize(text))) << text;
}

} // namespace
} // namespace parlour::adapters::nlu
