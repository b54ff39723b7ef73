#include "adapters/wyoming/wyoming_wake.hpp"
#include "tests/adapters/wyoming/wyoming_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class WyomingWakeTest : public test::WyomingTest {
protected:
  void use(test::WyomingServer::Serve serve, Options more = {}) {
    server = std::make_unique<test::WyomingServer>("wake", std::move(serve));
    more.merge(server->options());
    connect(wyoming_wake_factory(), more);
  }
  // Finds the first of the names it was told, in the third frame.
  static bool find(Peer& peer, const Event& event) {
    struct Heard {
      std::string name;
      int frames = 0;
    };
    auto& own = peer.own<Heard>();
    if (event.type == "detect")
      own.name = event.data.value("names", std::vector<std::string>{"any"})[0];
    else if (event.type == "audio-chunk" && ++own.frames == 3)
      peer.send({"detection",
                 {{"name", own.name}, {"timestamp", event.data["timestamp"]}}});
    return true;
  }

  std::unique_ptr<test::WyomingServer> server;
};

TEST_F(WyomingWakeTest, finds_a_word) {
  use(find, {{"keywords", " computer, robot"}});
  for (int i = 0; i < 3; ++i)
    send("Process", {frame(), 1'000 + 20 * i});
  const auto found = answer("Keyword");
  EXPECT_EQ(found.at(0), Value("computer"));
  EXPECT_EQ(found.at(2), Value(1'040));
}

TEST_F(WyomingWakeTest, counts_by_itself_and_looks_for_others) {
  use(find);
  send("SetKeywords", {Value(List{"robot"})});
  for (int i = 0; i < 3; ++i)
    send("Process", {frame()}, "s2");
  const auto found = answer("Keyword");
  EXPECT_EQ(found.at(0), Value("robot"));
  EXPECT_EQ(found.at(2), Value(40));
}

TEST_F(WyomingWakeTest, tells_once_that_too_many_sessions_listen) {
  use(find);
  for (int i = 0; i < 65; ++i)
    send("Process", {frame()}, "s" + std::to_string(i));
  for (int i = 1; i < 10; ++i) {
    send("Process", {frame()}, "s" + std::to_string(i));
    send("Process", {frame()}, "s64");
  }
  send("Process", {frame()}, "s0");
  send("Process", {frame()}, "s0");
  const auto failed = only(events_until("Keyword"), "Failed");
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_EQ(failed[0].session, "s64");
}

TEST_F(WyomingWakeTest, refuses_what_is_no_audio) {
  use(find);
  send("Process", {Binary{"mp3", {}}});
  EXPECT_THAT(answer("Failed").at(0).text(), HasSubstr("no audio"));
}

TEST_F(WyomingWakeTest, conforms) {
  const test::WyomingServer own("wake", find);
  EXPECT_THAT(
      conformance_errors(wyoming_wake_factory(),
                         {own.options(), Milliseconds(5'000), {}, {}, {}}),
      IsEmpty());
}

} // namespace
} // namespace parlour::adapters
