#include <future>

#include <gtest/gtest.h>

#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "adapters/database/sqlite/sqlite_open.hpp"
#include "adapters/database/sqlite/sqlite_watch.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;

class SQLiteWatchTest : public testing::Test {
protected:
  void write(const std::string& sql) {
    SQLiteConnection connection(open_file(file, Missing::create).value(), {},
                                1'000ms);
    ASSERT_TRUE(connection.run(sql, {}, Access::write));
  }

  test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.db";
};

TEST_F(SQLiteWatchTest, NoticesWhatOthersWrite) {
  write("create table a (b)");
  std::promise<void> changed;
  bool told = false;
  const auto watch = SQLiteWatch::start(file, 1ms, [&] {
    if (!std::exchange(told, true))
      changed.set_value();
  });
  ASSERT_TRUE(watch);
  write("insert into a values (1)");
  EXPECT_EQ(changed.get_future().wait_for(1min), std::future_status::ready);
}

TEST_F(SQLiteWatchTest, NeedsAFile) {
  EXPECT_FALSE(SQLiteWatch::start(file, 1ms, [] {}));
}

} // namespace
} // namespace parlour::adapters
