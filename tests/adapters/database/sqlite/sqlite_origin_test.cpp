#include "adapters/database/sqlite/sqlite_origin.hpp"
#include "tests/adapters/database/sqlite_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SQLiteOriginTest : public SQLiteTest {
protected:
  void start_again() {
    ASSERT_TRUE(start(file_options()));
    plugin->stop();
  }
};

TEST_F(SQLiteOriginTest, SaysThatTheSchemaHasChanged) {
  start_again();
  EXPECT_TRUE(folder.has("data/staff.db.made-from"));
  start_again();
  EXPECT_THAT(host.logs, IsEmpty());
  folder.write("schema.sql",
               folder.read("schema.sql") + "create table guest (name text);");
  start_again();
  EXPECT_THAT(host.logs, ElementsAre(testing::AllOf(
                             HasSubstr("schema or seed have changed"),
                             HasSubstr("--fresh"))));
}

TEST_F(SQLiteOriginTest, SaysThatTheSeedHasChanged) {
  start_again();
  folder.write("seed.sql", "insert into staff (name) values ('Ong');");
  start_again();
  EXPECT_THAT(host.logs, ElementsAre(HasSubstr("have changed")));
}

// Made by hand, or before marks were kept.
TEST_F(SQLiteOriginTest, SaysNothingWhereNobodyKnows) {
  start_again();
  folder.write("data/staff.db.made-from", "");
  folder.write("seed.sql", "");
  start_again();
  EXPECT_THAT(host.logs, IsEmpty());
}

TEST_F(SQLiteOriginTest, IsPutAsideAndMadeAnew) {
  ASSERT_TRUE(start(file_options()));
  write("insert into staff (name) values ('Ong')");
  plugin->stop();
  for (int time = 0; time < 2; ++time)
    EXPECT_TRUE(put_aside(folder.path() / "data/staff.db"));
  EXPECT_FALSE(folder.has("data/staff.db"));
  ASSERT_TRUE(start(file_options()));
  EXPECT_EQ(query("select count(*) from staff"), "Result([3])");
  plugin->stop();
}

TEST_F(SQLiteOriginTest, KeepsWhatWasPutAside) {
  ASSERT_TRUE(start(file_options()));
  write("insert into staff (name) values ('Ong')");
  plugin->stop();
  EXPECT_TRUE(put_aside(folder.path() / "data/staff.db"));
  ASSERT_TRUE(start(with(file_options(), "file", "staff.db.before")));
  EXPECT_EQ(query("select count(*) from staff"), "Result([4])");
  plugin->stop();
  start_again();
  EXPECT_TRUE(put_aside(folder.path() / "data/staff.db"));
  EXPECT_TRUE(folder.has("data/staff.db.before-2"));
  ASSERT_TRUE(start(with(file_options(), "file", "staff.db.before")));
  EXPECT_EQ(query("select count(*) from staff"), "Result([4])");
  plugin->stop();
}

} // namespace
} // namespace parlour::adapters
