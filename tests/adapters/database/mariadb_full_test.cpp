// What happens where there is no room any more.
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

// A server with room for a few megabytes in all.
class MariaDBFullTest : public MariaDBTest {
protected:
  tools::MariaDBServer& server() override {
    static const test::TemporaryFolder place;
    static tools::MariaDBServer shared(
        place.path(), {{"--innodb-file-per-table=0",
                        "--innodb-data-file-path=ibdata1:12M:autoextend:"
                        "max:14M"},
                       false,
                       false});
    return shared;
  }

  // Beds of 64 KiB until one does not fit; how many did.
  int fill() {
    write("create table beds (id integer primary key, room mediumtext)");
    int count = 0;
    do
      answer_ =
          write("insert into beds values (?, repeat('x', 65536))", List{count});
    while (answer_ == "Result([], 1)" && ++count < 1'000);
    return count;
  }
  std::string beds(const SessionId& session = "s1") {
    return query("select count(*) from beds", {}, session);
  }
  static std::string result(int count) {
    return "Result([" + std::to_string(count) + "])";
  }

  std::string answer_; // to the last attempt
};

TEST_F(MariaDBFullTest, SaysSoKeepsWhatItHasAndGoesOnWithRoom) {
  ASSERT_TRUE(start(options_for("full")));
  const int count = fill();
  EXPECT_THAT(answer_,
              AllOf(StartsWith("Error(Database, "), HasSubstr("is full")));
  EXPECT_GT(count, 0);
  EXPECT_EQ(beds(), result(count));
  server().kill();
  start_server();
  EXPECT_EQ(beds(), result(count));
  EXPECT_EQ(write("drop table beds"), "Result([], 0)");
  EXPECT_EQ(fill(), count);
  EXPECT_EQ(write("drop table beds"), "Result([], 0)");
}

TEST_F(MariaDBFullTest, RollsATransactionBack) {
  ASSERT_TRUE(start(options_for("full_transaction")));
  const int count = fill();
  EXPECT_EQ(tell("Begin"), "Result([])");
  EXPECT_EQ(write("update beds set id = id + 5000 where id = 0"),
            "Result([], 1)");
  EXPECT_THAT(write("insert into beds select id + 9000, room from beds"),
              StartsWith("Error(Database, "));
  EXPECT_EQ(tell("Rollback"), "Result([])");
  EXPECT_EQ(query("select max(id) from beds"), result(count - 1));
  EXPECT_EQ(write("drop table beds"), "Result([], 0)");
}

} // namespace
} // namespace parlour::adapters
