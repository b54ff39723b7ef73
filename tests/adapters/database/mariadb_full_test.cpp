// The database when its disk is full.
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

// Each test fills a server of its own.
class MariaDBFullTest : public MariaDBTest {
protected:
  MariaDBFullTest() {
    give_room("14M");
  }
  tools::MariaDBServer& server() override {
    return *server_;
  }
  // For all data of the server; 12 MB of it are the server's own.
  void give_room(const std::string& size) {
    server_ = nullptr;
    server_ = std::make_unique<tools::MariaDBServer>(
        place_.path(),
        tools::MariaDBServerOptions{
            {"--innodb-file-per-table=0",
             "--innodb-data-file-path=ibdata1:12M:autoextend:max:" + size},
            false,
            false});
  }

  void make_beds() {
    ASSERT_EQ(write("create table beds (id integer primary key, "
                    "room mediumtext)"),
              "Result([], 0)");
  }
  // Beds of 64 KiB until one does not fit; how many did.
  int fill() {
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

  test::TemporaryFolder place_;
  std::unique_ptr<tools::MariaDBServer> server_;
  std::string answer_; // to the last attempt
};

TEST_F(MariaDBFullTest, SaysSoKeepsWhatItHasAndGoesOnWithRoom) {
  ASSERT_TRUE(start(options_for("full")));
  make_beds();
  const int count = fill();
  EXPECT_THAT(answer_,
              AllOf(StartsWith("Error(Database, "), HasSubstr("is full")));
  EXPECT_GT(count, 0);
  EXPECT_EQ(beds(), result(count));
  server().kill();
  start_server();
  EXPECT_EQ(beds(), result(count));
  give_room("24M");
  start_server();
  EXPECT_EQ(
      write("insert into beds values (?, repeat('x', 65536))", List{count}),
      "Result([], 1)");
  EXPECT_EQ(beds(), result(count + 1));
}

// InnoDB itself may hang where it finds no room for what it would undo.
TEST_F(MariaDBFullTest, RollsATransactionBack) {
  ASSERT_TRUE(
      start(with(options_for("full_transaction"), "query-timeout", "1s")));
  make_beds();
  EXPECT_EQ(write("insert into beds values (5000, 'small')"), "Result([], 1)");
  EXPECT_EQ(tell("Begin"), "Result([])");
  EXPECT_EQ(write("update beds set room = 'smaller'"), "Result([], 1)");
  EXPECT_GT(fill(), 0);
  EXPECT_THAT(answer_, AnyOf(StartsWith("Error(Database, "),
                             StartsWith("Error(Timeout, ")));
  EXPECT_THAT(tell("Rollback"),
              AnyOf("Result([])", HasSubstr("was rolled back")));
  give_room("24M");
  start_server();
  EXPECT_EQ(query("select id, room from beds"), "Result([5000, small])");
}

} // namespace
} // namespace parlour::adapters
