#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/conversations.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(ConversationsTest, HaveWhatUsersSay) {
  Conversations read;
  read_conversation("# comment\nU: Hello there.\r\nR: Good morning\n"
                    "U(voice=rms, noise=babble20): A taxi: now!\nU:\nUsual\n"
                    "expect slot Taxi.Destination = Bedok Mall\n"
                    "expect slot Taxi.Time = unknown\nexpect slot Odd\nU: end",
                    read);
  EXPECT_THAT(read.lines, ElementsAre("Hello there.", "A taxi: now!", "end"));
  EXPECT_THAT(read.values, ElementsAre(Pair("Taxi.Destination", "Bedok Mall")));
}

TEST(ConversationsTest, AreReadFromAFolder) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "b.txt") << "U: two\n";
  std::ofstream(folder.path() / "a.txt") << "U: one\n";
  std::ofstream(folder.path() / "c.md") << "U: three\n";
  EXPECT_THAT(read_conversations(folder.path()).lines,
              ElementsAre("one", "two"));
  EXPECT_THAT(read_conversations(folder.path() / "none").lines, IsEmpty());
}

} // namespace
} // namespace parlour::adapters::asr
