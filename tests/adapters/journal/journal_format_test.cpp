#include <gmock/gmock.h>

#include "adapters/journal/journal_format.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

const std::string two =
    std::string(journal_magic) + framed("first") + framed("");

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
  for (auto size = journal_magic.size(); size < two.size(); ++size) {
    const auto cut = two.substr(0, size);
    auto reader = JournalReader::over(cut).value();
    while (const auto record = reader.next())
      EXPECT_TRUE(*record);
    EXPECT_EQ(reader.position(), size < first ? journal_magic.size() : first);
    EXPECT_EQ(reader.position() + reader.torn_bytes(), size);
  }
}

TEST(JournalFormat, AnyOtherByteIsNoticed) {
  const auto one = std::string(journal_magic) + framed("a record");
  for (std::size_t at = 0; at < one.size(); ++at) {
    auto changed = one;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    auto reader = JournalReader::over(changed);
    if (at < journal_magic.size()) {
      EXPECT_FALSE(reader);
      continue;
    }
    // A size that is now larger makes the last record an unfinished one.
    const auto record = reader->next();
    EXPECT_TRUE(!record || !*record) << at;
    if (record) {
      EXPECT_THAT(record->error().message,
                  HasSubstr("byte " + std::to_string(journal_magic.size())));
    }
  }
}

TEST(JournalFormat, ASizeThatCannotBeIsDamage) {
  auto bytes = two;
  bytes[journal_magic.size() + 3] = '\x7f';
  EXPECT_THAT(JournalReader::over(bytes)->next()->error().message,
              HasSubstr("damaged"));
}

TEST(JournalFormat, SaysWhatIsNoJournal) {
  EXPECT_THAT(JournalReader::over("hello").error().message,
              HasSubstr("no journal"));
}

} // namespace
} // namespace parlour::adapters
