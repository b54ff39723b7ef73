// Whole sessions that a crash has left are in tests/actors/sessions and
// tests/tools/parlour.
#include <gmock/gmock.h>

#include "script/dialogue/inputs/recovery.hpp"
#include "script/vm/program_identity.hpp"
#include "tests/script/dialogue/inputs/noted_world.hpp"

namespace parlour::dialogue {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* bell = R"xml(
  <state name="S"><Entrance><speak param="Good morning."/>
    <post module="Bell" command="Ring" param=""/></Entrance></state>
  )xml";

// The history of a conversation, as a journal would have it.
struct Kept : NotedWorld {
  SessionHistory history;

  Kept() : NotedWorld(bell) {
    history.id = "s1";
    history.opened = {script::identity_of(*program), 1, true, "desk"};
    keep();
  }
  void take(SessionInput input) override {
    NotedWorld::take(std::move(input));
    keep();
  }
  Expected<std::unique_ptr<SavedSession>> recovered() const {
    return recover(program, nullptr, history);
  }

private:
  // What was noted since.
  void keep() {
    for (auto i = history.inputs.size(); i < inputs.size(); ++i)
      history.inputs.push_back(
          {to_bytes(*program, inputs[i]), to_bytes(*program, answers[i])});
  }
};

TEST(Recovery, BringsBackWhatWas) {
  Kept kept;
  const auto saved = kept.recovered().value();
  EXPECT_EQ(saved->id, "s1");
  EXPECT_EQ(saved->seat, "desk");
  EXPECT_EQ(saved->inputs, kept.history.inputs.size());
  EXPECT_EQ(saved->state, kept.conversation->save());
  ASSERT_THAT(saved->turns.said, SizeIs(1));
  EXPECT_EQ(saved->turns.said[0].text, "Good morning.");
}

TEST(Recovery, GoesOnFromAState) {
  Kept kept;
  kept.history.state = kept.conversation->save();
  kept.history.before = kept.history.inputs.size();
  kept.history.inputs.clear();
  EXPECT_EQ(kept.recovered().value()->state, kept.conversation->save());
}

// What may not have left is posted again; without a strict journal it had.
TEST(Recovery, KnowsWhatMayNotHaveLeft) {
  Kept kept;
  EXPECT_THAT(kept.recovered().value()->posts, SizeIs(1));
  kept.history.posted = kept.history.inputs.size();
  EXPECT_THAT(kept.recovered().value()->posts, IsEmpty());
  kept.history.posted = 0;
  kept.history.opened.strict = false;
  EXPECT_THAT(kept.recovered().value()->posts, IsEmpty());
}

TEST(Recovery, WhatHasEndedStaysEnded) {
  Kept kept;
  kept.take(input::Closed());
  EXPECT_EQ(kept.recovered().value(), nullptr);
  kept.history.closed = true;
  EXPECT_EQ(kept.recovered().value(), nullptr);
}

TEST(Recovery, RefusesWhatIsNotTheSame) {
  Kept kept;
  auto other = kept.history;
  other.opened.program ^= 1;
  EXPECT_THAT(recover(kept.program, nullptr, other).error().message,
              HasSubstr("other scripts"));
  other = kept.history;
  other.state = "x";
  EXPECT_FALSE(recover(kept.program, nullptr, other));
  other = kept.history;
  other.opened.seed = 2;
  other.inputs.front().answers = to_bytes(*kept.program, PortAnswers{});
  EXPECT_THAT(recover(kept.program, nullptr, other).error().message,
              HasSubstr("input 1: "));
  other.inputs.front().input.pop_back();
  EXPECT_FALSE(recover(kept.program, nullptr, other));
}

} // namespace
} // namespace parlour::dialogue
