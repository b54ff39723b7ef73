#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "runtime/message/roles.hpp"

namespace parlour {

TEST(Roles, are_found_by_name_and_by_alias) {
  ASSERT_TRUE(find_role("Microphone"));
  EXPECT_EQ(find_role("Record"), find_role("Microphone"));
  EXPECT_EQ(canonical_role("Record"), "Microphone");
  EXPECT_EQ(canonical_role("AlsaMicrophone"), "AlsaMicrophone");
  EXPECT_FALSE(find_role("Recrod"));
}

TEST(Roles, know_what_ends_a_request) {
  const auto* asr = find_role("ASR");
  ASSERT_TRUE(asr);
  EXPECT_EQ(asr->event("Partial")->reply, Reply::none);
  EXPECT_EQ(asr->event("RecognitionResult")->reply, Reply::answer);
  EXPECT_EQ(asr->event("Rejected")->reply, Reply::answer);
  EXPECT_EQ(find_role("Taxi")->event("Refused")->reply, Reply::refusal);
  EXPECT_EQ(find_role("Database")->event("Error")->reply, Reply::refusal);
  EXPECT_FALSE(asr->event("Speak"));
}

TEST(Roles, know_what_nobody_has_to_take) {
  EXPECT_TRUE(find_role("TTS")->event("Mark")->routine);
  EXPECT_TRUE(find_role("Speaker")->event("Finished")->routine);
  EXPECT_FALSE(find_role("Speaker")->event("Failed")->routine);
  EXPECT_FALSE(find_role("Telephone")->event("Answered")->routine);
}

TEST(Roles, list_their_commands) {
  EXPECT_TRUE(find_role("NLU")->command("DoNLU"));
  EXPECT_EQ(find_role("Robot")->command("Goto")->parameters, "place");
  EXPECT_FALSE(find_role("Robot")->command("Fly"));
  EXPECT_TRUE(find_role("Robot")->command("Goto")->answered);
  EXPECT_FALSE(find_role("Robot")->command("Stop")->answered);
}

TEST(Roles, have_an_answer_to_what_is_always_answered) {
  for (const auto& role : roles())
    for (const auto& command : role.commands)
      EXPECT_TRUE(!command.answered ||
                  std::ranges::any_of(role.events,
                                      [](const RoleEvent& event) {
                                        return event.reply == Reply::answer;
                                      }))
          << role.name << " " << command.name;
}

TEST(Roles, reserve_the_sources_that_are_no_components) {
  for (const auto* name : {"Session", "Timer", "System", "Script", "Dialogue"})
    EXPECT_TRUE(find_role(name)->reserved) << name;
  EXPECT_FALSE(find_role("TTS")->reserved);
}

TEST(Roles, have_names_of_their_own) {
  std::set<std::string> seen;
  for (const auto& role : roles()) {
    EXPECT_TRUE(seen.insert(role.name).second) << role.name;
    for (const auto& alias : role.aliases)
      EXPECT_TRUE(seen.insert(alias).second) << alias;
    EXPECT_FALSE(role.sentence.empty()) << role.name;
    EXPECT_FALSE(role.events.empty()) << role.name;
  }
}

} // namespace parlour
