#include <gtest/gtest.h>

#include "runtime/message/replies.hpp"

namespace parlour {
namespace {

TEST(Replies, AreWhatTheRoleSays) {
  EXPECT_EQ(find_reply("Ringing", {"Telephone"}), Reply::none);
  EXPECT_EQ(find_reply("Answered", {"Telephone"}), Reply::answer);
  EXPECT_EQ(find_reply("Refused", {"Robot", "Taxi"}), Reply::refusal);
}

TEST(Replies, ThenWhatTheComponentSaysOfItsOwn) {
  const std::vector<RoleEvent> own = {{"Warm", "degrees", Reply::none},
                                      {"Baked", "", Reply::answer},
                                      {"Burnt", "", Reply::refusal},
                                      {"Answered", "", Reply::none}};
  EXPECT_EQ(find_reply("Warm", {"Oven"}, own), Reply::none);
  EXPECT_EQ(find_reply("Baked", {"Oven"}, own), Reply::answer);
  EXPECT_EQ(find_reply("Burnt", {"Oven"}, own), Reply::refusal);
  EXPECT_EQ(find_reply("Answered", {"Telephone"}, own), Reply::answer);
}

TEST(Replies, OfNobodysKnowledge) {
  EXPECT_EQ(find_reply("Failed", {"Oven"}), Reply::refusal);
  EXPECT_EQ(find_reply("Anything", {"Oven"}), std::nullopt);
}

} // namespace
} // namespace parlour
