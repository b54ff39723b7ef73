#include <thread>

#include "adapters/database/sqlite/sqlite_image.hpp"
#include "tests/adapters/database/sqlite_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

class SQLiteImageTest : public SQLiteTest {
protected:
  Expected<SQLiteImage> image() {
    return sqlite_image(folder.path() / "schema.sql",
                        folder.path() / "seed.sql");
  }
};

std::string count(SQLiteConnection& db) {
  auto answer = db.run("select count(*) from staff", {}, Access::read);
  return answer ? to_string(Value(answer->rows)) : answer.error().message;
}

TEST_F(SQLiteImageTest, IsMadeOnce) {
  auto first = image();
  ASSERT_TRUE(first);
  EXPECT_EQ(*first, *image());
  folder.write("seed.sql", "insert into staff (name) values ('Ong')");
  EXPECT_NE(*first, *image());
}

TEST_F(SQLiteImageTest, GivesEachItsOwnCopyFromAnyThread) {
  std::vector<std::string> counts(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < counts.size(); ++i)
    threads.emplace_back([&, i] {
      SQLiteConnection db(open_image(*image()).value(), {}, Milliseconds(0));
      for (std::size_t n = 0; n < i; ++n)
        (void)db.run("insert into staff (name) values (?)",
                     List{"n" + std::to_string(n)}, Access::write);
      counts[i] = count(db);
    });
  for (auto& thread : threads)
    thread.join();
  for (std::size_t i = 0; i < counts.size(); ++i)
    EXPECT_EQ(counts[i], "[" + std::to_string(3 + i) + "]");
}

TEST_F(SQLiteImageTest, MayBeEmpty) {
  auto empty = sqlite_image({}, {});
  ASSERT_TRUE(empty);
  SQLiteConnection db(open_image(*empty).value(), {}, Milliseconds(0));
  EXPECT_TRUE(db.run("create table a (b)", {}, Access::write));
}

TEST_F(SQLiteImageTest, PlacesErrorsInTheFile) {
  folder.write("schema.sql",
               "create table a (b);\n\n-- more\ncreate\n tabel c;");
  auto wrong = image();
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().kind, ErrorKind::database);
  EXPECT_THAT(wrong.error().place.file, HasSubstr("schema.sql"));
  EXPECT_EQ(wrong.error().place.line, 5u);
  EXPECT_THAT(wrong.error().message, HasSubstr("near \"tabel\""));
}

TEST_F(SQLiteImageTest, PlacesErrorsOfTheSeed) {
  folder.write("seed.sql", "insert into staff (name) values ('A');\n"
                           "insert into staff (name) values ('A');\n");
  auto wrong = image();
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().place.line, 2u);
  EXPECT_THAT(wrong.error().message, HasSubstr("UNIQUE"));
}

TEST_F(SQLiteImageTest, ReadsNoHalfOfAFile) {
  using namespace std::string_literals;
  folder.write("schema.sql", "create table a (b);\n\0create table c (d);"s);
  auto wrong = image();
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().place.line, 2u);
  EXPECT_THAT(wrong.error().message, HasSubstr("zero byte"));
}

TEST_F(SQLiteImageTest, KeepsItsTransaction) {
  folder.write("seed.sql", "rollback;");
  auto wrong = image();
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, HasSubstr("leave out 'begin'"));
}

TEST_F(SQLiteImageTest, NeedsItsFiles) {
  for (const auto& path : {folder.path() / "missing.sql", folder.path()}) {
    auto wrong = sqlite_image(path, {});
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().kind, ErrorKind::file);
    EXPECT_EQ(wrong.error().place.file, path.string());
  }
}

TEST_F(SQLiteImageTest, IsWrittenWholeAndLeavesNothingElse) {
  folder.write("deep/er/staff.db-wal", "of a database that is gone");
  const auto file = folder.path() / "deep" / "er" / "staff.db";
  ASSERT_TRUE(write_image(*image(), file));
  std::size_t files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(file.parent_path()))
    files += entry.path() == file ? 1U : 100U;
  EXPECT_EQ(files, 1u);
}

TEST_F(SQLiteImageTest, SaysWhereItCannotBeWritten) {
  folder.write("file", "not a folder");
  auto wrong = write_image(*image(), folder.path() / "file" / "staff.db");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().kind, ErrorKind::file);
}

} // namespace
} // namespace parlour::adapters
