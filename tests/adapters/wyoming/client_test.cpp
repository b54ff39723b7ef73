#include <future>

#include "adapters/wyoming/client.hpp"
#include "adapters/wyoming/wyoming_asr.hpp"
#include "tests/adapters/wyoming/wyoming_fixture.hpp"

namespace parlour::adapters::wyoming {
namespace {

using testing::HasSubstr;

// By a plug-in that uses it.
class WyomingClientTest : public test::WyomingTest {
protected:
  static bool nothing(Peer&, const Event&) {
    return true;
  }
};

TEST_F(WyomingClientTest, says_that_the_server_goes_and_comes) {
  auto server = std::make_unique<test::WyomingServer>("asr", nothing);
  const auto options = server->options();
  const auto port = server->port();
  connect(wyoming_asr_factory(), options);
  server.reset();
  EXPECT_TRUE(says("ended the connection"));
  EXPECT_TRUE(host.wait([&] { return !host.is_available(); }, patience));
  server = std::make_unique<test::WyomingServer>("asr", nothing, port);
  EXPECT_TRUE(says("connected"));
  EXPECT_TRUE(host.wait([&] { return host.is_available(); }, patience));
}

TEST_F(WyomingClientTest, knows_its_options) {
  for (const auto* option : {"connect-timeout", "answer-timeout", "pause"})
    EXPECT_THAT(start(wyoming_asr_factory(), {{option, "0s"}}).error().message,
                HasSubstr(option));
}

// A loop that is behind: each session that has lost something is told, once
// until it has been.
TEST_F(WyomingClientTest, tells_each_session_that_it_has_a_hole) {
  test::WyomingServer server("asr", nothing);
  const auto client =
      Client::start(host, server.options(), client_options("10300"), "asr");
  ASSERT_TRUE(client);
  auto& posts = **client;
  std::vector<std::string> told;
  const auto say = [&](const SessionId& session, std::size_t bytes) {
    posts.post(
        session, [&told, session] { told.push_back(session + " is heard"); },
        bytes, [&told, session] { told.push_back(session + " has a hole"); });
  };
  for (int round = 0; round < 2; ++round) {
    told.clear();
    std::promise<void> goes_on;
    std::promise<void> done;
    posts.post([&] { goes_on.get_future().wait(); });
    say("s1", Client::max_posted);
    for (const auto* session : {"s1", "s2", "s1", "s2"})
      say(session, 1);
    posts.post([&] { done.set_value(); });
    goes_on.set_value();
    done.get_future().wait();
    EXPECT_THAT(told, testing::ElementsAre("s1 is heard", "s1 has a hole",
                                           "s2 has a hole"));
  }
}

} // namespace
} // namespace parlour::adapters::wyoming
