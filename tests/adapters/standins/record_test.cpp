#include <gtest/gtest.h>

#include "adapters/standins/record.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

TEST(Record, HasALineForAMessage) {
  test::TemporaryFolder folder;
  Record record;
  ASSERT_TRUE(record.open(folder.path() / "a" / "b.log"));
  const auto time = parse_timestamp("2026-11-21 10:30:05").value();
  EXPECT_TRUE(record.write(time, test::message("Ask", {"Changi", 2.5})));
  EXPECT_TRUE(record.write(time, test::message("Ask\tall", {})));
  EXPECT_EQ(folder.read("a/b.log"), "2026-11-21T10:30:05\tAsk\tChangi,2.5\n"
                                    "2026-11-21T10:30:05\tAsk\\tall\t\n");
}

TEST(Record, SaysWhenItCannotBeWritten) {
  Record record;
  EXPECT_FALSE(record.write(0, test::message("Ask")));
  EXPECT_FALSE(record.open("/dev/null/records/x.log"));
}

} // namespace
} // namespace parlour::adapters
