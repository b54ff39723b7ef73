#include <gtest/gtest.h>

#include "tools/parlour/speech/spoken.hpp"

namespace parlour::tools {
namespace {

using adapters::Sample;

Message event(std::string command, std::vector<Value> params) {
  Message message;
  message.command = std::move(command);
  message.params = std::move(params);
  return message;
}

Message audio(const std::vector<Sample>& samples) {
  return event("Audio", {adapters::pcm_value(samples, {})});
}

TEST(SpokenTest, CollectsTheSoundUntilItIsFinished) {
  Spoken spoken;
  spoken.take(audio({1, 2}));
  spoken.take(event("Mark", {1, "word", 0}));
  spoken.take(audio({3}));
  EXPECT_FALSE(spoken.is_over());
  spoken.take(event("Finished", {1}));
  EXPECT_TRUE(spoken.is_over());
  EXPECT_EQ(spoken.samples, (std::vector<Sample>{1, 2, 3}));
  EXPECT_EQ(spoken.trouble, "");
}

TEST(SpokenTest, SaysWhyNothingIsSpoken) {
  Spoken refused;
  refused.take(event("Failed", {"no such voice"}));
  EXPECT_TRUE(refused.is_over());
  EXPECT_EQ(refused.trouble, "no such voice");
  Spoken silent;
  silent.take(event("Failed", {}));
  EXPECT_EQ(silent.trouble, "it failed");
  Spoken unreadable;
  unreadable.take(event("Audio", {"no sound"}));
  EXPECT_NE(unreadable.trouble, "");
}

} // namespace
} // namespace parlour::tools
