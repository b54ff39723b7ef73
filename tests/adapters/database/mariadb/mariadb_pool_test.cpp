// The connections when the server dies, hangs or comes back, and when many
// sessions query it.
#include "adapters/database/mariadb/mariadb_pool.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::AnyOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

const std::string how_many = "select count(*) from staff";

class MariaDBPoolTest : public MariaDBTest {
protected:
  // One that stays when the server dies, answered as it comes.
  Options lasting(const std::string& database) {
    return with(options_for(database), "one-by-one", "false");
  }

  // Until the server runs a statement of another connection that has `part` in
  // it.
  void wait_until_running(const std::string& part) {
    const std::string running =
        "select count(*) from information_schema.processlist where "
        "id <> connection_id() and command = 'Execute' and info like '%" +
        part + "%'";
    while (query(running, {}, "watcher") == "Result([0])") {
    }
  }
  void connect() {
    while (tell("Connect") != "Result([])") {
    }
  }
};

TEST_F(MariaDBPoolTest, ReadsAgainWhenTheServerCameBack) {
  ASSERT_TRUE(start(lasting("back")));
  EXPECT_EQ(query(how_many), "Result([3])");
  server().kill();
  start_server();
  EXPECT_EQ(query(how_many), "Result([3])");
  EXPECT_EQ(write("update staff set level = 5"), "Result([], 3)");
}

TEST_F(MariaDBPoolTest, SaysThatTheServerHasGoneAndFindsItAgain) {
  ASSERT_TRUE(start(with(lasting("gone"), "busy-timeout", "100ms")));
  server().stop();
  EXPECT_THAT(query(how_many), StartsWith("Error(Offline, The database server "
                                          "cannot be reached: "));
  EXPECT_THAT(tell("Connect"), StartsWith("Error(Offline, "));
  start_server();
  connect();
  EXPECT_EQ(query(how_many), "Result([3])");
}

TEST_F(MariaDBPoolTest, ComesUpBeforeTheServer) {
  server().stop();
  ASSERT_TRUE(start(with(lasting("later"), "busy-timeout", "100ms")));
  EXPECT_THAT(host.logs, ElementsAre(HasSubstr("cannot be reached yet")));
  EXPECT_THAT(query(how_many), StartsWith("Error(Offline, "));
  start_server();
  connect();
  EXPECT_EQ(query(how_many), "Result([3])");
}

TEST_F(MariaDBPoolTest, IsInDoubtAboutAWriteThatTheServerDiedOver) {
  ASSERT_TRUE(start(lasting("doubt")));
  send("s1", "Query",
       {"insert into staff (name) select 'Ong' from (select sleep(60)) as t",
        List{}, true});
  wait_until_running("Ong");
  server().kill();
  EXPECT_THAT(host.wait_for_events(1),
              ElementsAre(StartsWith("Error(InDoubt, 'insert into staff")));
  start_server();
  EXPECT_EQ(query(how_many), "Result([3])");
}

TEST_F(MariaDBPoolTest, RepeatsAReadThatTheServerDiedOver) {
  ASSERT_TRUE(start(with(lasting("again"), "query-timeout", "1m")));
  // Somebody has the lock, until the server dies.
  tell("Begin", {}, "s2");
  EXPECT_EQ(query("select get_lock('gate', 0)", {}, "s2"), "Result([1])");
  send("s1", "Query", {"select get_lock('gate', 60) + 41"});
  wait_until_running("60) + 41");
  server().kill();
  start_server();
  EXPECT_THAT(host.wait_for_events(1), ElementsAre("Result([42])"));
}

TEST_F(MariaDBPoolTest, LosesATransactionWithTheServer) {
  ASSERT_TRUE(start(lasting("lost")));
  tell("Begin");
  write("delete from staff");
  server().kill();
  start_server();
  EXPECT_THAT(write("delete from staff"), StartsWith("Error("));
  EXPECT_THAT(tell("Commit"),
              StartsWith("Error(Database, Commit: the transaction was rolled "
                         "back"));
  EXPECT_EQ(query(how_many), "Result([3])");
}

TEST_F(MariaDBPoolTest, GivesUpAServerThatHangs) {
  ASSERT_TRUE(start(with(with(lasting("hangs"), "query-timeout", "50ms"),
                         "busy-timeout", "200ms")));
  server().pause();
  EXPECT_THAT(query(how_many), StartsWith("Error(Timeout, "));
  EXPECT_THAT(write("delete from staff"), AnyOf(StartsWith("Error(InDoubt, "),
                                                StartsWith("Error(Offline, "),
                                                StartsWith("Error(Timeout, ")));
  server().go_on();
}

TEST_F(MariaDBPoolTest, EndsAStatementThatTakesTooLong) {
  ASSERT_TRUE(start(with(options(), "query-timeout", "50ms")));
  EXPECT_THAT(query("select sleep(60) from staff"),
              StartsWith("Error(Timeout, 'select sleep(60) from staff' "
                         "failed: Query execution was interrupted"));
  EXPECT_EQ(query(how_many), "Result([3])");
}

TEST_F(MariaDBPoolTest, AnswersManyAtATime) {
  ASSERT_TRUE(start(lasting("many")));
  for (int i = 0; i < 200; ++i)
    send("s" + std::to_string(i), "Query", {"select ? + 1", List{41}});
  const auto answers = host.wait_for_events(200);
  EXPECT_THAT(answers, SizeIs(200));
  EXPECT_THAT(answers, Each("Result([42])"));
}

TEST_F(MariaDBPoolTest, LetsNoMoreWaitThanItCanRemember) {
  ASSERT_TRUE(start(
      with(with(lasting("full"), "connections", "1"), "busy-timeout", "2s")));
  send("s0", "Query", {"select sleep(60)"});
  for (int i = 0; i < 1'000; ++i)
    send("s1", "Query", {"select 1"});
  EXPECT_THAT(host.wait_for_events(1),
              ElementsAre("Error(Limit, Too many wait for the database.)"));
  // The others wait for a connection, but not for ever.
  const auto late = host.wait_for_events(999);
  EXPECT_THAT(late, SizeIs(999));
  EXPECT_THAT(late, Each(StartsWith("Error(Timeout, All connections")));
  plugin->stop();
  EXPECT_THAT(host.wait_for_events(1),
              ElementsAre("Error(Offline, The database was closed.)"));
}

TEST_F(MariaDBPoolTest, DoesNotWaitForAStatementWhenItStops) {
  ASSERT_TRUE(start(lasting("stops")));
  send("s1", "Query",
       {"insert into staff (name) select 'Tay' from (select sleep(60)) as t",
        List{}, true});
  wait_until_running("Tay");
  plugin->stop();
  EXPECT_THAT(host.wait_for_events(1),
              ElementsAre(StartsWith("Error(InDoubt, ")));
}

} // namespace
} // namespace parlour::adapters
