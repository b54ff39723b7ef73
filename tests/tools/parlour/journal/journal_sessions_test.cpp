#include <gmock/gmock.h>

#include "adapters/journal/journal_format.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/journal/journal_sessions.hpp"

namespace parlour::tools {
namespace {

using dialogue::HistoryFrom;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string record(const SessionId& id,
                   decltype(dialogue::SessionRecord::what) what) {
  return adapters::framed(dialogue::to_bytes({id, std::move(what)}));
}
std::string opened(const SessionId& id) {
  return record(id, dialogue::SessionOpened{1, 2, false});
}
std::string input(const SessionId& id) {
  return record(id, dialogue::InputTaken{"in", "out"});
}
std::string state(const SessionId& id, std::uint64_t inputs) {
  return record(id, dialogue::StateKept{{1, 2, false}, inputs, "state", {}});
}

class JournalSessionsTest : public testing::Test {
protected:
  const test::TemporaryFolder folder;

  void part(int number, const std::string& records, std::uint64_t needed = 1) {
    folder.write("00000" + std::to_string(number) + ".journal",
                 adapters::part_header(needed) + records);
  }
  JournalSessions read(HistoryFrom from = HistoryFrom::last_state) {
    return read_sessions(folder.path(), from).value();
  }
};

TEST_F(JournalSessionsTest, GivesEachSessionItsRecords) {
  part(1, opened("a") + opened("b") + input("a"));
  part(2, input("a") + input("b"));
  const auto all = read();
  ASSERT_THAT(all.sessions, SizeIs(2));
  EXPECT_EQ(all.sessions[0].id, "a");
  EXPECT_THAT(all.sessions[0].inputs, SizeIs(2));
  EXPECT_THAT(all.sessions[1].inputs, SizeIs(1));
  EXPECT_THAT(all.broken, IsEmpty());
}

TEST_F(JournalSessionsTest, ReadsOnlyWhatIsNeededToGoOn) {
  part(1, opened("a") + opened("b") + input("a"));
  part(2, state("a", 1) + input("a"), 2);
  auto all = read();
  ASSERT_THAT(all.sessions, SizeIs(1));
  EXPECT_EQ(all.sessions[0].before, 1u);
  all = read(HistoryFrom::beginning);
  ASSERT_THAT(all.sessions, SizeIs(2));
  EXPECT_THAT(all.sessions[0].inputs, SizeIs(2));
}

TEST_F(JournalSessionsTest, WhatACrashLeftUnfinishedIsLeftOut) {
  part(1, opened("a") + input("a").substr(0, 14));
  part(2, opened("b"));
  const auto all = read();
  EXPECT_EQ(all.torn, 14u);
  EXPECT_THAT(all.sessions, SizeIs(2));
  EXPECT_THAT(all.damages, IsEmpty());
}

TEST_F(JournalSessionsTest, TellsOfDamageAndOfWhomItConcerns) {
  auto bad = input("a");
  bad.back() ^= 1;
  part(1, opened("a") + opened("b") + opened("c") +
              record("b", dialogue::SessionClosed{}) + bad);
  part(2, input("a") + state("c", 4) + input("c"));
  const auto all = read();
  EXPECT_THAT(all.damages, ElementsAre(HasSubstr("000001.journal: byte")));
  EXPECT_THAT(all.broken, ElementsAre("a"));
  ASSERT_THAT(all.sessions, SizeIs(2));
  EXPECT_EQ(all.sessions[1].id, "c");
  EXPECT_EQ(all.sessions[1].before, 4u);
}

TEST_F(JournalSessionsTest, AnIdMayComeAgain) {
  part(1, opened("a") + input("a") + opened("a"));
  const auto all = read();
  ASSERT_THAT(all.sessions, SizeIs(2));
  EXPECT_THAT(all.sessions[1].inputs, IsEmpty());
}

TEST_F(JournalSessionsTest, SaysThatThereIsNone) {
  EXPECT_THAT(
      read_sessions(folder.path(), HistoryFrom::beginning).error().message,
      HasSubstr("no journal"));
  EXPECT_FALSE(read_sessions(folder.path() / "no", HistoryFrom::beginning));
}

} // namespace
} // namespace parlour::tools
