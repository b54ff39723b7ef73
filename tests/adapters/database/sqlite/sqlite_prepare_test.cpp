#include <gmock/gmock.h>

#include "adapters/database/sqlite/sqlite_prepare.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {

TEST(SQLitePreparer, tells_what_does_not_fit_and_where) {
  test::TemporaryFolder folder;
  folder.write("schema.sql", "create table guest (name text, room int);");
  const auto image = sqlite_image(folder.path() / "schema.sql", {});
  ASSERT_TRUE(image);
  const auto preparer = SQLitePreparer::open(*image);
  ASSERT_TRUE(preparer);
  EXPECT_FALSE(preparer->problem_of("select name from guest where room = ?"));
  EXPECT_FALSE(preparer->problem_of(""));
  const auto column = preparer->problem_of("select nme from guest");
  ASSERT_TRUE(column);
  EXPECT_EQ(column->message, "no such column: nme");
  EXPECT_EQ(column->offset, 7u);
  const auto table = preparer->problem_of("select 1 from nobody");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->message, "no such table: nobody");
  EXPECT_THAT(preparer->names(),
              testing::UnorderedElementsAre("guest", "name", "room"));
}

} // namespace parlour::adapters
