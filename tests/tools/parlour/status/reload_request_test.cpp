#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/status/reload_request.hpp"

namespace parlour::tools {
namespace {

using actors::ReloadMode;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(ReloadRequest, IsReadBack) {
  for (const auto mode :
       {ReloadMode::keep, ReloadMode::restart, ReloadMode::new_only}) {
    const auto read =
        reload_request_from_json(to_json(ReloadRequest{mode, true}));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->mode, mode);
    EXPECT_TRUE(read->undo);
  }
}

TEST(ReloadRequest, IsOneLineWithoutItsEnd) {
  EXPECT_EQ(to_json(ReloadRequest{}).find('\n'), std::string::npos);
}

TEST(ReloadRequest, RefusesWhatIsNone) {
  EXPECT_FALSE(reload_request_from_json("{"));
  EXPECT_FALSE(reload_request_from_json("{}"));
  const auto read =
      reload_request_from_json(R"({"mode": "twice", "undo": false})");
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("'twice'"));
}

TEST(ReloadReply, IsReadBack) {
  const auto read =
      reload_reply_from_json(to_json(ReloadReply{{"a"}, {"b", "c"}}));
  ASSERT_TRUE(read);
  EXPECT_THAT(read->errors, ElementsAre("a"));
  EXPECT_THAT(read->notes, ElementsAre("b", "c"));
}

TEST(ReloadReply, TellsWhatHasBecomeOfAll) {
  actors::ReloadOutcome outcome;
  outcome.sessions.gone_over = 41;
  outcome.sessions.later = 1;
  outcome.sessions.lost = {{"the state 'Welcome'", 1}, {"the slot 'A.B'", 3}};
  outcome.loaded = {"GrammarNLU", "City"};
  outcome.unloaded = {"Bell"};
  EXPECT_THAT(
      notes_of(outcome, ReloadMode::keep),
      ElementsAre("41 conversations go on with the changed scripts, 1 more as "
                  "soon as it is at rest",
                  "lost: the slot 'A.B', in 3 conversations",
                  "lost: the state 'Welcome', in 1 conversation",
                  "loaded: GrammarNLU, City", "unloaded: Bell"));
}

TEST(ReloadReply, SaysWhichWayTheyWent) {
  actors::ReloadOutcome outcome;
  outcome.sessions.gone_over = 1;
  EXPECT_THAT(notes_of(outcome, ReloadMode::restart),
              ElementsAre("1 conversation begins again"));
  EXPECT_THAT(notes_of({}, ReloadMode::new_only),
              ElementsAre(HasSubstr("keep the scripts that they have")));
}

} // namespace
} // namespace parlour::tools
