#include <map>

#include "actors/sessions/session_sockets.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using Kind = SocketEvent::Kind;

// The other sides of sockets, moved by the test.
class OtherSides : public Sockets {
public:
  Id open(SocketOrder order, Tell tell) override {
    told.push_back("open " + order.address + (order.lines ? " lines" : ""));
    tell_[++last_] = std::move(tell);
    return last_;
  }
  Expected<void> send(Id id, const std::string& text) override {
    told.push_back("send " + std::to_string(id) + " " + text);
    return {};
  }
  void taken(Id id) override {
    told.push_back("taken " + std::to_string(id));
  }
  void close(Id id) override {
    told.push_back("close " + std::to_string(id));
    tell_.erase(id);
  }
  void tell(Id id, Kind kind, std::string text = "") {
    if (tell_.contains(id))
      tell_[id]({kind, std::move(text)});
  }

  std::vector<std::string> told;

private:
  std::map<Id, Tell> tell_;
  Id last_ = 0;
};

class SessionSocketsTest : public NodeFixture {
protected:
  SessionSocketsTest() {
    options.sockets = others;
  }
  std::vector<std::string> hear(Sockets::Id id, Kind kind,
                                std::string text = "") {
    others->tell(id, kind, std::move(text));
    node->run_until_quiet();
    return said();
  }
  std::vector<std::string> told() {
    return std::exchange(others->told, {});
  }

  std::shared_ptr<OtherSides> others = std::make_shared<OtherSides>();
};

constexpr const char* feed = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <try>
        <socket name="feed" connect="{_LPARAM1}"/>
        <sendsocket name="feed" param="hello"/>
        <speak param="open"/>
        <catch name="e"><speak param="{e.kind}: {e.message}"/></catch>
      </try>
    </RecognitionResult></ASR>
    <feed>
      <Data><speak param="got {_LPARAM1}"/></Data>
      <Closed><speak param="closed: {_LPARAM1}"/></Closed>
    </feed>
  </component></messages></handler>)";

TEST_F(SessionSocketsTest, OpenTalkAndEnd) {
  start(feed);
  EXPECT_THAT(say({"there:1"}), IsEmpty());
  EXPECT_THAT(hear(1, Kind::opened), ElementsAre("open"));
  EXPECT_THAT(told(), ElementsAre("open there:1 lines", "send 1 hello"));
  EXPECT_THAT(hear(1, Kind::text, "one"), ElementsAre("got one"));
  EXPECT_THAT(told(), ElementsAre("taken 1"));
  EXPECT_THAT(hear(1, Kind::closed, "gone"), ElementsAre("closed: gone"));
  EXPECT_THAT(say({"there:2"}), IsEmpty()); // the name is free again
  EXPECT_THAT(hear(2, Kind::failed, "refused"),
              ElementsAre("Network: refused"));
  EXPECT_THAT(told(), ElementsAre("open there:2 lines"));
  EXPECT_THAT(ways_of("Data"), ElementsAre("feed.Data(one) | session"));
}

TEST_F(SessionSocketsTest, CloseWithTheirSession) {
  start(feed);
  say({"there:1"});
  hear(1, Kind::opened);
  told();
  node->end(node->session_at(seat));
  node->run_until_quiet();
  EXPECT_THAT(told(), ElementsAre("close 1"));
  EXPECT_THAT(hear(1, Kind::text, "late"), IsEmpty());
}

TEST_F(SessionSocketsTest, CloseWhenNobodyWaitsForThemAnyMore) {
  start(feed);
  say({"there:1"});
  told();
  node->end(node->session_at(seat));
  node->run_until_quiet();
  EXPECT_THAT(told(), ElementsAre("close 1"));
}

// What the routes end was dealt with.
TEST_F(SessionSocketsTest, GoByTheRoutes) {
  start(std::string(feed) + R"(<routes>
    <filter source="feed" command="Data" drop="true"/></routes>)");
  say({"there:1"});
  hear(1, Kind::opened);
  told();
  EXPECT_THAT(hear(1, Kind::text, "one"), IsEmpty());
  EXPECT_THAT(told(), ElementsAre("taken 1"));
  EXPECT_THAT(ways_of("Data"), ElementsAre("feed.Data(one) | dropped"));
}

TEST_F(SessionSocketsTest, AreRefusedWithoutANetwork) {
  options.sockets = nullptr;
  start(feed);
  EXPECT_THAT(say({"there:1"}),
              ElementsAre(HasSubstr("Network: this run has no network")));
}

} // namespace
} // namespace parlour::actors
