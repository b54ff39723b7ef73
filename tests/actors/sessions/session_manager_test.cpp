#include "actors/sessions/session_manager.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

class SessionManagerTest : public testing::Test {
protected:
  SessionManagerTest() {
    bench.bus.connect(bench.centre_probe());
  }

  // At a seat of its own.
  seat_actor open() {
    auto seat = bench.seat_probe();
    bench.send(manager, open_session{seat, bench.work()});
    return seat;
  }
  void say(const std::string& session, std::vector<Message> messages) {
    for (auto& message : messages)
      message.session = session;
    forward_all(std::move(messages));
  }
  void wish(const std::string& session, std::vector<Subscription> to) {
    bench.send(manager, subscribe{session, std::move(to), bench.work()});
  }
  void forward_all(std::vector<Message> messages) {
    bench.send(manager, forward{std::move(messages), bench.work()});
  }

  Bench bench{std::string(loses_its_session) + R"(
    <state name="Here"><Exit><speak param="Bye."/></Exit></state>
    <handler name="H"><messages><component>
      <Bell>
        <Rings><speak param="Ding {_LPARAM1}"/></Rings>
        <Strikes><speak param="Struck {_LPARAM1}"/></Strikes>
      </Bell>
      <ASR><RecognitionResult><speak param="{_LPARAM1}!"/></RecognitionResult>
      </ASR>
    </component></messages></handler>
    <routes><open source="Bell" command="Strikes" seat="lobby"/></routes>)"};
  int ids = 0;
  SessionParts parts{bench.time, bench.bus, bench.observer, bench.program,
                     std::make_shared<ThrowingPhrases>()};
  SessionNames names{[this] { return "s" + std::to_string(++ids); },
                     [] { return 1; }};
  session_manager_actor manager =
      bench.spawn(session_manager, parts, &bench.sessions, names);
};

TEST_F(SessionManagerTest, OpensAndClosesOneOfSeveral) {
  open();
  open();
  EXPECT_TRUE(bench.sessions.find("s1"));
  EXPECT_TRUE(bench.sessions.find("s2"));
  bench.send(manager, close_session{"s1", bench.work()});
  EXPECT_FALSE(bench.sessions.find("s1"));
  EXPECT_TRUE(bench.sessions.find("s2"));
  EXPECT_THAT(bench.seen, testing::Contains("s1 is over"));
  EXPECT_THAT(bench.logs, IsEmpty());
  EXPECT_TRUE(bench.time.work.none());
}

TEST_F(SessionManagerTest, ClosesAll) {
  open();
  open();
  bench.send(manager, close_session{"", bench.work()});
  EXPECT_THAT(bench.sessions.all(), IsEmpty());
}

TEST_F(SessionManagerTest, PassesMessagesOn) {
  open();
  open();
  forward_all({event("Bell", "Rings", {1}, "s2")});
  EXPECT_THAT(bench.seen, ElementsAre("says Ding 1"));
}

TEST_F(SessionManagerTest, PassesToThoseWhoSubscribed) {
  open();
  open();
  open();
  wish("s1", {{"Bell", "*"}});
  wish("s2", {{"*", "Rings"}, {"Bell", "Rings"}});
  wish("s3", {{"Bell", "Falls"}});
  forward_all({event("Bell", "Rings", {1})});
  EXPECT_THAT(bench.seen, ElementsAre("says Ding 1", "says Ding 1"));
  wish("s1", {});
  wish("nobody", {{"*", "*"}});
  bench.send(manager, close_session{"s2", bench.work()});
  bench.seen.clear();
  forward_all({event("Bell", "Rings", {2})});
  EXPECT_THAT(bench.seen, IsEmpty());
  EXPECT_THAT(bench.logs, ElementsAre(HasSubstr("no session has subscribed")));
}

// What answers somebody is nobody else's.
TEST_F(SessionManagerTest, PassesNoLateAnswerToThoseWhoSubscribed) {
  open();
  wish("s1", {{"*", "*"}});
  auto late = event("Bell", "Rings", {1});
  late.correlation = 7;
  forward_all({late});
  EXPECT_THAT(bench.seen, IsEmpty());
  EXPECT_THAT(bench.logs, ElementsAre(HasSubstr("no session has subscribed")));
}

// Engine rule 1.8.
TEST_F(SessionManagerTest, OpensAConversationForWhatASensorSays) {
  const auto lobby = bench.seat_probe();
  const auto desk = bench.seat_probe();
  bench.send(manager, seat_opened{"lobby", lobby, bench.work()});
  bench.send(manager, seat_opened{"desk", desk, bench.work()});
  bench.send(manager, open_session{desk, bench.work()});
  forward_all({event("Bell", "Rings", {1})}); // not of that kind
  EXPECT_FALSE(bench.sessions.find("s2"));
  bench.logs.clear();
  forward_all({event("Bell", "Strikes", {1})});
  EXPECT_THAT(bench.seen, ElementsAre("s2 is next", "says Struck 1"));
  forward_all({event("Bell", "Strikes", {2})}); // there is one now
  EXPECT_FALSE(bench.sessions.find("s3"));
  EXPECT_THAT(bench.logs, ElementsAre(HasSubstr("no session has subscribed")));
  bench.send(manager, close_session{"s1", bench.work()});
  forward_all({event("Bell", "Strikes", {3})});
  EXPECT_FALSE(bench.sessions.find("s3")); // the desk is not meant
  auto late = event("Bell", "Strikes", {4});
  late.correlation = 7; // answers somebody
  bench.send(manager, close_session{"s2", bench.work()});
  forward_all({late});
  EXPECT_FALSE(bench.sessions.find("s3"));
}

// A component of the seat names the seat while nothing goes on there.
TEST_F(SessionManagerTest, OpensAConversationForWhatASeatsOwnComponentSays) {
  bench.send(manager, seat_opened{"lobby", bench.seat_probe(), bench.work()});
  bench.send(manager, seat_opened{"desk", bench.seat_probe(), bench.work()});
  say("lobby", {event("Bell", "Rings", {1})});  // not of that kind
  say("desk", {event("Bell", "Strikes", {1})}); // not meant
  EXPECT_THAT(bench.seen, IsEmpty());
  EXPECT_THAT(bench.logs,
              ElementsAre(HasSubstr("Bell.Rings"), HasSubstr("Bell.Strikes")));
  bench.logs.clear();
  say("lobby", {event("Bell", "Strikes", {2}), event("Bell", "Rings", {3})});
  EXPECT_THAT(bench.seen,
              ElementsAre("s1 is next", "says Struck 2", "says Ding 3"));
  bench.seen.clear();
  say("lobby", {event("Bell", "Rings", {4})}); // it goes on now
  EXPECT_THAT(bench.seen, ElementsAre("says Ding 4"));
  EXPECT_THAT(bench.logs, IsEmpty());
  EXPECT_TRUE(bench.time.work.none());
}

TEST_F(SessionManagerTest, SaysWhatNobodyTakes) {
  open();
  forward_all({event("Bell", "Rings", {}, "nobody")});
  forward_all({event("Bell", "Falls"),
               event("System", "Falls")}); // for those who listen, if any
  EXPECT_THAT(bench.logs, ElementsAre(HasSubstr("its session is over"),
                                      HasSubstr("no session has subscribed")));
}

TEST_F(SessionManagerTest, HasOneSessionAtASeat) {
  auto seat = open();
  bench.send(manager, open_session{seat, bench.work()});
  EXPECT_FALSE(bench.sessions.find("s2"));
}

// A turn on its way to a session that has ended is the next one's at its seat;
// what answered the old one is not.
TEST_F(SessionManagerTest, TakesLateTurnsToTheSeatsNextSession) {
  auto seat = open();
  bench.send(manager, close_session{"s1", bench.work()});
  bench.seen.clear();
  say("s1", {event("ASR", "RecognitionResult", {"one"}),
             event("System", "ComponentFailed"),
             event("ASR", "RecognitionResult", {"two"})});
  EXPECT_THAT(bench.seen, ElementsAre("s2 is next", "says one!", "says two!"));
  EXPECT_THAT(bench.logs, ElementsAre(HasSubstr("System.ComponentFailed")));
  bench.seen.clear();
  say("s1", {event("ASR", "RecognitionResult", {"three"})});
  EXPECT_THAT(bench.seen, ElementsAre("says three!"));
  EXPECT_TRUE(bench.time.work.none());
}

// A recogniser that answers a message copies its correlation.
TEST_F(SessionManagerTest, KnowsATurnByWhatItIs) {
  open();
  bench.send(manager, close_session{"s1", bench.work()});
  bench.seen.clear();
  auto heard = event("ASR", "RecognitionResult", {"one"}, "s1");
  heard.correlation = 7;
  forward_all({heard});
  EXPECT_THAT(bench.seen, ElementsAre("s2 is next", "says one!"));
}

TEST_F(SessionManagerTest, OpensNothingWhenTheNodeCloses) {
  open();
  bench.send(manager, close_session{"", bench.work()});
  say("s1", {event("ASR", "RecognitionResult", {"one"})});
  EXPECT_THAT(bench.sessions.all(), IsEmpty());
  EXPECT_THAT(bench.logs, ElementsAre(HasSubstr("its session is over")));
}

TEST_F(SessionManagerTest, NoticesALoss) {
  open();
  open();
  bench.send(bench.sessions.find("s1"),
             deliver{{event("Bell", "Breaks", {}, "s1")}, bench.work()});
  EXPECT_THAT(bench.logs,
              ElementsAre(testing::AllOf(HasSubstr("session s1 was lost: "),
                                         HasSubstr("broken"))));
  EXPECT_THAT(bench.seen, ElementsAre("s1 is over"));
  forward_all({event("Bell", "Rings", {3}, "s2")});
  EXPECT_THAT(bench.seen, testing::Contains("says Ding 3"));
  EXPECT_TRUE(bench.time.work.none());
}

} // namespace
} // namespace parlour::actors
