#include <gmock/gmock.h>

#include "adapters/journal/journal_format.hpp"
#include "adapters/journal/journal_part.hpp"
#include "runtime/base/outside/file_bytes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

TEST(JournalPart, AppendsToItsHeader) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "000003.journal";
  auto part = JournalPart::make(path, 2, JournalSync::on_disk).value();
  ASSERT_TRUE(part.append("one"));
  ASSERT_TRUE(part.append("two"));
  EXPECT_EQ(read_file(path).value(), part_header(2) + "onetwo");
  EXPECT_EQ(part.size(), part_header(2).size() + 6);
}

TEST(JournalPart, IsNotMadeOverAnother) {
  const test::TemporaryFolder folder;
  folder.write("000003.journal", "kept");
  const auto path = folder.path() / "000003.journal";
  const auto part = JournalPart::make(path, 1, JournalSync::with_system);
  ASSERT_FALSE(part);
  EXPECT_THAT(part.error().message, HasSubstr("exists"));
  EXPECT_EQ(folder.read("000003.journal"), "kept");
}

} // namespace
} // namespace parlour::adapters
