// A session is repeated from notes that are made up; that true notes lead to
// the same again is tested by every World (conversation_world.cpp).
#include <gmock/gmock.h>

#include "script/dialogue/inputs/replay.hpp"
#include "tests/script/dialogue/inputs/noted_world.hpp"

namespace parlour::dialogue {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* greeting = R"xml(
  <state name="S"><Entrance><speak param="Good morning."/></Entrance></state>
  )xml";

struct Notes : NotedWorld {
  Notes() : NotedWorld(greeting) {}
};

TEST(Replay, SaysAndKnowsTheSame) {
  Notes notes;
  Replay replay(notes.program, {"s1", 1, nullptr});
  Texts said;
  replay.port().on_output = [&](const Output& output) {
    said.push_back(output.text);
  };
  for (std::size_t i = 0; i < notes.inputs.size(); ++i)
    EXPECT_TRUE(replay.take(notes.inputs[i], notes.answers[i]));
  EXPECT_THAT(said, ElementsAre("Good morning."));
  EXPECT_EQ(replay.conversation().save(), notes.conversation->save());
}

TEST(Replay, SaysWhereItDiffers) {
  Notes notes;
  for (std::size_t changed = 0; changed < notes.inputs.size(); ++changed) {
    Replay replay(notes.program, {"s1", 1, nullptr});
    for (std::size_t i = 0; i < notes.inputs.size(); ++i) {
      auto answers = notes.answers[i];
      answers.wishes ^= i == changed;
      const auto same = replay.take(notes.inputs[i], answers);
      EXPECT_EQ(same.has_value(), i != changed);
      if (!same) {
        EXPECT_THAT(same.error().message, HasSubstr("something else"));
      }
    }
  }
}

TEST(Replay, SaysWhatItWasNotAskedFor) {
  Notes notes;
  Replay replay(notes.program, {"s1", 1, nullptr});
  auto answers = notes.answers[0];
  answers.letters += "y";
  const auto same = replay.take(notes.inputs[0], answers);
  ASSERT_FALSE(same);
  EXPECT_THAT(same.error().message, HasSubstr("less"));
}

TEST(Replay, GoesOnFromBytes) {
  Notes notes;
  const auto saved = notes.conversation->save();
  auto replay = Replay::from(notes.program, {"s1", 1, nullptr}, saved).value();
  EXPECT_EQ(replay->conversation().save(), saved);
  EXPECT_FALSE(Replay::from(notes.program, {"s1", 1, nullptr}, "?"));
}

TEST(Replay, AsksWhereNobodyHasNotedTheAnswers) {
  Notes notes;
  Replay replay(notes.program, {"s1", 1, nullptr});
  for (const auto& input : notes.inputs)
    replay.take(input, notes);
  EXPECT_EQ(replay.conversation().save(), notes.conversation->save());
}

} // namespace
} // namespace parlour::dialogue
