#include "adapters/database/sqlite/sqlite_columns.hpp"
#include "tests/adapters/database/sqlite_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SQLiteColumnsTest : public SQLiteTest {
protected:
  Expected<std::vector<std::string>> read(const std::string& reference,
                                          const Options& options) {
    return sqlite_column_reader(options, host.data,
                                host.application)(reference);
  }
};

TEST_F(SQLiteColumnsTest, HaveDistinctValuesInOrder) {
  EXPECT_THAT(read("db:staff.name", options()).value(),
              ElementsAre("Dr. Jeffery Ho", "Lim", "Tan Ah Kow"));
  EXPECT_THAT(read("db:staff.level", options()).value(), ElementsAre("13"));
}

TEST_F(SQLiteColumnsTest, ComeFromSchemaAndSeedWhereThereIsNoFile) {
  EXPECT_EQ(read("db:staff.name", file_options())->size(), 3u);
  EXPECT_FALSE(folder.has("data"));
}

TEST_F(SQLiteColumnsTest, ComeFromTheFileAsItIsNow) {
  ASSERT_TRUE(start(file_options()));
  write("insert into staff (name) values ('Ong')");
  EXPECT_THAT(read("db:staff.name", file_options()).value(),
              ElementsAre("Dr. Jeffery Ho", "Lim", "Ong", "Tan Ah Kow"));
}

TEST_F(SQLiteColumnsTest, SayWhatIsMissing) {
  for (auto reference : {"db:staff.nam", "db:stuff.name"}) {
    auto wrong = read(reference, options());
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().kind, ErrorKind::database);
    EXPECT_THAT(wrong.error().message, HasSubstr(reference));
    EXPECT_THAT(wrong.error().message, HasSubstr("no such"));
  }
  EXPECT_FALSE(read("db:staff.name", {{"busy-timeout", "soon"}}));
  EXPECT_FALSE(read("db:staff.name", {{"schema", "missing.sql"}}));
}

} // namespace
} // namespace parlour::adapters
