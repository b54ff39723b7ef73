#include <stdexcept>

#include "actors/session_manager.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

class SessionManagerTest : public testing::Test {
protected:
  SessionManagerTest() {
    bench.services.manager = manager;
    bench.services.centre = bench.centre_probe();
    seat = bench.seat_probe();
  }

  void open() {
    bench.send(manager, open_session{seat, bench.work()});
  }
  void forward_all(std::vector<Message> messages) {
    bench.send(manager, forward{std::move(messages), bench.work()});
  }

  Bench bench{R"(
    <state name="Here"><Exit><speak param="Bye."/></Exit></state>
    <handler name="H"><messages><component>
      <Bell><Rings><speak param="Ding {_LPARAM1}"/></Rings></Bell>
    </component></messages></handler>)"};
  session_manager_actor manager = bench.spawn(session_manager, &bench.services);
  seat_actor seat;
};

TEST_F(SessionManagerTest, OpensAndClosesOneOfSeveral) {
  open();
  open();
  EXPECT_TRUE(bench.services.sessions.find("s1"));
  EXPECT_TRUE(bench.services.sessions.find("s2"));
  bench.send(manager, close_session{"s1", bench.work()});
  EXPECT_FALSE(bench.services.sessions.find("s1"));
  EXPECT_TRUE(bench.services.sessions.find("s2"));
  EXPECT_THAT(bench.seen, testing::Contains("s1 is over"));
  EXPECT_THAT(bench.logs, IsEmpty());
  EXPECT_TRUE(bench.services.work.none());
}

TEST_F(SessionManagerTest, ClosesAll) {
  open();
  open();
  bench.send(manager, close_session{"", bench.work()});
  EXPECT_THAT(bench.services.sessions.all(), IsEmpty());
}

TEST_F(SessionManagerTest, PassesMessagesOn) {
  open();
  open();
  forward_all({event("Bell", "Rings", {1}, "s2"), event("Bell", "Rings", {2})});
  EXPECT_THAT(bench.seen, testing::UnorderedElementsAre(
                              "says Ding 1", "says Ding 2", "says Ding 2"));
}

TEST_F(SessionManagerTest, SaysWhatNobodyTakes) {
  open();
  forward_all({event("Bell", "Rings", {}, "nobody"), event("Bell", "Falls"),
               event("System", "Falls")}); // for those who listen, if any
  EXPECT_THAT(bench.logs, ElementsAre(HasSubstr("its session is over"),
                                      HasSubstr("no session listens to it")));
}

TEST_F(SessionManagerTest, NoticesALoss) {
  open();
  open();
  auto lost = bench.services.sessions.find("s1");
  bench.send(lost, look{[](const auto&) { throw std::runtime_error("broken"); },
                        bench.work()});
  EXPECT_THAT(bench.logs,
              ElementsAre(testing::AllOf(HasSubstr("session s1 was lost: "),
                                         HasSubstr("broken"))));
  EXPECT_THAT(bench.seen, ElementsAre("s1 is over"));
  forward_all({event("Bell", "Rings", {3}, "s2")});
  EXPECT_THAT(bench.seen, testing::Contains("says Ding 3"));
  EXPECT_TRUE(bench.services.work.none());
}

} // namespace
} // namespace parlour::actors
