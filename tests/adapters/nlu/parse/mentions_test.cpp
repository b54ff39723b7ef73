#include <gtest/gtest.h>

#include "adapters/nlu/parse/mentions.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

std::string understood(const char* text) {
  static const auto engine = sample();
  return summary(
      engine.understand(text, sample_context("Facility.Category")).acts);
}

TEST(Mentions, AreLeftOutBesideASentenceThatIsAValue) {
  EXPECT_EQ(understood("The bank. I zorked them at the toilet."),
            understood("The bank."));
  EXPECT_EQ(understood("My dog zorked at the toilet. The bank."),
            understood("The bank."));
}

TEST(Mentions, AreWhatIsWantedWhereNothingElseIsSaid) {
  EXPECT_NE(understood("I zorked them at the toilet."), "");
  EXPECT_NE(understood("The bank. I mean the toilet."),
            understood("The bank."));
  EXPECT_NE(understood("The bank. Or the toilet."), understood("The bank."));
  EXPECT_NE(understood("The bank. Where is the toilet?"),
            understood("The bank."));
}

TEST(Mentions, AreWhatSomebodyHasOrHad) {
  EXPECT_EQ(understood("The bank. The toilet was zorked."),
            understood("The bank."));
  EXPECT_EQ(understood("The bank, as always. Zoe has the toilet."),
            understood("The bank, as always."));
}

} // namespace
} // namespace parlour::adapters::nlu::test
