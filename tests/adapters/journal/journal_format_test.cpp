#include <gmock/gmock.h>

#include "adapters/journal/journal_format.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

const std::string two = part_header(1) + framed("first") + framed("");

TEST(JournalFormat, GivesTheRecordsInTheirOrder) {
  auto reader = JournalReader::over(two).value();
  EXPECT_EQ(reader.next()->value(), "first");
  EXPECT_EQ(reader.next()->value(), "");
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.position(), two.size());
  EXPECT_EQ(reader.torn_bytes(), 0u);
}

TEST(JournalFormat, ARecordThatIsCutOffIsNoDamage) {
  const auto first = two.size() - framed("").size();
  const auto header = part_header(1).size();
  for (std::size_t size = 0; size < two.size(); ++size) {
    const auto cut = two.substr(0, size);
    auto reader = JournalReader::over(cut).value();
    while (const auto record = reader.next())
      EXPECT_TRUE(*record);
    EXPECT_EQ(reader.position(), size < header  ? 0
                                 : size < first ? header
                                                : first);
    EXPECT_EQ(reader.position() + reader.torn_bytes(), size);
  }
}

TEST(JournalFormat, AnyOtherByteIsNoticed) {
  const auto one = part_header(1) + framed("a record");
  for (std::size_t at = 0; at < one.size(); ++at) {
    auto changed = one;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    auto reader = JournalReader::over(changed);
    if (at < part_header(1).size()) {
      EXPECT_FALSE(reader);
      continue;
    }
    const auto record = reader->next();
    ASSERT_TRUE(record) << at;
    ASSERT_FALSE(*record) << at;
    EXPECT_THAT(record->error().message,
                HasSubstr("byte " + std::to_string(part_header(1).size())));
  }
}

TEST(JournalFormat, ASizeThatCannotBeIsDamage) {
  auto bytes = two;
  bytes[part_header(1).size() + 3] = '\x7f';
  EXPECT_THAT(JournalReader::over(bytes)->next()->error().message,
              HasSubstr("damaged"));
}

// As a loss of power leaves a file whose size was known before its contents.
TEST(JournalFormat, ZerosAtTheEndAreNoDamage) {
  const auto bytes = two + std::string(100, '\0');
  auto reader = JournalReader::over(bytes).value();
  EXPECT_TRUE(reader.next()->has_value());
  EXPECT_TRUE(reader.next()->has_value());
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.torn_bytes(), 100u);
}

TEST(JournalFormat, FindsTheParts) {
  const test::TemporaryFolder folder;
  folder.write("000002.journal", part_header(2));
  folder.write("1000000.journal", part_header(2).substr(0, 20));
  folder.write("notes.journal", "");
  folder.write("000000.journal", "");
  const auto parts = parts_of(folder.path()).value();
  EXPECT_THAT(parts, ElementsAre(Pair(2, part_path(folder.path(), 2)),
                                 Pair(1'000'000, testing::_)));
  EXPECT_EQ(first_needed(parts), 2u);
  EXPECT_EQ(first_needed({}), 1u);
  EXPECT_FALSE(parts_of(folder.path() / "no"));
}

TEST(JournalFormat, SaysWhatIsNoJournal) {
  EXPECT_THAT(JournalReader::over("hello").error().message,
              HasSubstr("no part of a journal"));
}

} // namespace
} // namespace parlour::adapters
