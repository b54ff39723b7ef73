#include <gtest/gtest.h>

#include "script/dialogue/inputs/session_record.hpp"

namespace parlour::dialogue {
namespace {

TEST(SessionRecord, IsReadAsItWasWritten) {
  const auto opened =
      read_record(to_bytes({"K3f9", SessionOpened{7, 8, false, "desk"}}))
          .value();
  EXPECT_EQ(opened.session, "K3f9");
  EXPECT_EQ(std::get<SessionOpened>(opened.what).program, 7u);
  EXPECT_EQ(std::get<SessionOpened>(opened.what).seed, 8u);
  EXPECT_EQ(std::get<SessionOpened>(opened.what).seat, "desk");
  const std::string any("\0\xff", 2);
  const auto taken =
      read_record(to_bytes({"K3f9", InputTaken{any, "b"}})).value();
  EXPECT_EQ(std::get<InputTaken>(taken.what).input, any);
  EXPECT_EQ(std::get<InputTaken>(taken.what).answers, "b");
}

TEST(SessionRecord, AStateHasTheTurnsThatWereTaken) {
  StateKept kept{{7, 8, true}, 1'000, "state", {}};
  kept.turns.taken = 5;
  kept.turns.done = 4;
  kept.turns.said = {{5, 12, OutputAct::question, "When?"}};
  const auto record = read_record(to_bytes({"K3f9", kept})).value();
  const auto& read = std::get<StateKept>(record.what);
  EXPECT_TRUE(read.opened.strict);
  EXPECT_EQ(read.inputs, 1'000u);
  EXPECT_EQ(read.state, "state");
  EXPECT_EQ(read.turns.taken, 5u);
  EXPECT_EQ(read.turns.done, 4u);
  ASSERT_EQ(read.turns.said.size(), 1u);
  EXPECT_EQ(read.turns.said[0].turn, 5u);
  EXPECT_EQ(read.turns.said[0].output, 12u);
  EXPECT_EQ(read.turns.said[0].act, OutputAct::question);
  EXPECT_EQ(read.turns.said[0].text, "When?");
  auto bytes = to_bytes({"K3f9", kept});
  bytes[bytes.size() - 7] = 9; // the act
  EXPECT_FALSE(read_record(bytes));
}

TEST(SessionRecord, SaysWhatIsDoneAndOver) {
  const auto done = read_record(to_bytes({"K3f9", EffectsDone{3}})).value();
  EXPECT_EQ(std::get<EffectsDone>(done.what).inputs, 3u);
  const auto over = read_record(to_bytes({"K3f9", SessionClosed{}})).value();
  EXPECT_TRUE(std::holds_alternative<SessionClosed>(over.what));
}

TEST(SessionRecord, DamagedBytesAreAnError) {
  const StateKept kept{
      {7, 8, true}, 9, "state", {1, 1, {{1, 2, OutputAct::chat, "Yes."}}}};
  for (const auto& bytes : {to_bytes({"K3f9", InputTaken{"input", "b"}}),
                            to_bytes({"K3f9", kept})}) {
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_FALSE(read_record(bytes.substr(0, size)));
    EXPECT_FALSE(read_record(bytes + "x"));
  }
  EXPECT_EQ(read_record(std::string("\3\7\0", 3)).error().kind,
            ErrorKind::file);
  EXPECT_FALSE(read_record(std::string("\1\0\0", 3)));
}

} // namespace
} // namespace parlour::dialogue
