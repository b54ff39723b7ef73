#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "adapters/database/sqlite/sqlite_open.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

TEST(OpenFile, CreatesOnlyWhenTold) {
  test::TemporaryFolder folder;
  const auto file = folder.path() / "a.db";
  auto refused = open_file(file, Missing::refuse);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::file);
  EXPECT_EQ(refused.error().place.file, file.string());
  EXPECT_FALSE(folder.has("a.db"));
  EXPECT_TRUE(open_file(file, Missing::create));
}

TEST(CheckSound, SaysWhatToDoAboutADamagedFile) {
  test::TemporaryFolder folder;
  for (auto text : {"", "this is no database, whatever its name says"}) {
    folder.write("a.db", text);
    auto sound = check_sound(folder.path() / "a.db", Milliseconds(0));
    ASSERT_FALSE(sound);
    EXPECT_EQ(sound.error().kind, ErrorKind::database);
    EXPECT_THAT(sound.error().message, HasSubstr("move it away"));
  }
}

int keep_number(void* into, int, char** cells, char**) {
  *static_cast<int*>(into) = std::stoi(cells[0]);
  return 0;
}

TEST(AllowWriting, WaitsForOthersAsLongAsItIsTold) {
  test::TemporaryFolder folder;
  const auto file = folder.path() / "a.db";
  const auto handle = open_file(file, Missing::create).value();
  ASSERT_TRUE(allow_writing(handle.get(), file, Milliseconds(30)));
  int waits = 0;
  sqlite3_exec(handle.get(), "pragma busy_timeout", &keep_number, &waits,
               nullptr);
  EXPECT_EQ(waits, 30);
}

TEST(AllowWriting, LetsReadersAndAWriterWorkTogether) {
  test::TemporaryFolder folder;
  const auto file = folder.path() / "a.db";
  auto handle = open_file(file, Missing::create).value();
  ASSERT_TRUE(allow_writing(handle.get(), file, Milliseconds(0)));
  SQLiteConnection writer(std::move(handle), {}, Milliseconds(0));
  ASSERT_TRUE(writer.run("create table a (b)", {}, Access::write));
  SQLiteConnection reader(open_file(file, Missing::refuse).value(), {},
                          Milliseconds(0));
  ASSERT_TRUE(writer.begin());
  ASSERT_TRUE(writer.run("insert into a values (1)", {}, Access::write));
  auto seen = reader.run("select count(*) from a", {}, Access::read);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_EQ(seen->rows.cells.at(0), Value(0));
  auto busy = reader.run("delete from a", {}, Access::write);
  ASSERT_FALSE(busy);
  EXPECT_THAT(busy.error().message, HasSubstr("another program holds"));
}

} // namespace
} // namespace parlour::adapters
