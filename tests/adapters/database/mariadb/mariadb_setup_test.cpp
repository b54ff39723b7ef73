#include <thread>

#include "adapters/database/mariadb/mariadb_setup.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

using MariaDBSetupTest = MariaDBTest;

const std::string staff = "select count(*) from staff";

TEST_F(MariaDBSetupTest, LeavesAloneWhatIsThere) {
  ASSERT_TRUE(start(options_for("there")));
  EXPECT_EQ(write("delete from staff where id > 1"), "Result([], 2)");
  ASSERT_TRUE(start(options_for("there")));
  EXPECT_EQ(query(staff), "Result([1])");
}

TEST_F(MariaDBSetupTest, BeginsAnewAfterASeedThatFails) {
  const auto seed = folder.read("seed.sql");
  folder.write("seed.sql", seed + "\ninsert into nowhere values (1)");
  EXPECT_FALSE(start(options_for("anew")));
  folder.write("seed.sql", seed);
  const auto started = start(options_for("anew"));
  ASSERT_TRUE(started) << started.error().message;
  EXPECT_EQ(query(staff), "Result([3])");
  EXPECT_EQ(query("select count(*) from information_schema.tables where "
                  "table_schema = '" +
                  name_of("anew") + "'"),
            "Result([1])");
}

TEST_F(MariaDBSetupTest, BeginsAnewWithViews) {
  const auto schema = folder.read("schema.sql");
  folder.write("schema.sql",
               schema + "\n;create view names as select name from staff;");
  const auto seed = folder.read("seed.sql");
  folder.write("seed.sql", "insert into nowhere values (1)");
  EXPECT_FALSE(start(options_for("viewed")));
  folder.write("seed.sql", seed);
  const auto started = start(options_for("viewed"));
  ASSERT_TRUE(started) << started.error().message;
  EXPECT_EQ(query("select count(*) from names"), "Result([3])");
}

TEST_F(MariaDBSetupTest, IsMadeByOneOfSeveral) {
  auto first = mysql_database_factory().create();
  auto second = mysql_database_factory().create();
  Expected<void> started;
  WaitingHost other;
  other.application = folder.path().string();
  std::thread thread(
      [&] { started = first->start(other, options_for("one")); });
  EXPECT_TRUE(second->start(host, options_for("one")));
  thread.join();
  EXPECT_TRUE(started);
  plugin = std::move(second);
  EXPECT_EQ(query(staff), "Result([3])");
}

} // namespace
} // namespace parlour::adapters
