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

Message refusal(const char* command, List params) {
  Message event;
  event.source = "City";
  event.command = command;
  event.params = std::move(params);
  return event;
}

TEST(Replies, ADatabaseNamesTheKindOfItsErrors) {
  struct {
    const char* named;
    ErrorKind kind;
  } const cases[] = {
      {"Database", ErrorKind::database}, {"InDoubt", ErrorKind::in_doubt},
      {"Timeout", ErrorKind::timeout},   {"Offline", ErrorKind::offline},
      {"Refused", ErrorKind::refused},   {"Whatever", ErrorKind::database}};
  for (const auto& [named, kind] : cases) {
    const auto event = refusal("Error", {named, "no"});
    EXPECT_EQ(error_of(event, true).kind, kind) << named;
    EXPECT_EQ(error_of(event, false).kind, ErrorKind::refused) << named;
    EXPECT_EQ(error_of(event, false).message, "no");
  }
  for (const auto& event : {refusal("Error", {"Timeout"}), // words, no kind
                            refusal("Failed", {"Timeout", "no"})})
    EXPECT_EQ(error_of(event, true).kind, ErrorKind::database);
}

TEST(Replies, ARefusalNamesWhoRefused) {
  EXPECT_EQ(refusal_of(refusal("Error", {"Timeout", "locked"}), true),
            (Error{ErrorKind::timeout, "City: locked", {}}));
  EXPECT_EQ(refusal_of(refusal("Full", {}), false),
            (Error{ErrorKind::refused, "City: Full", {}}));
}

} // namespace
} // namespace parlour
