#include "adapters/wyoming/server_watch.hpp"
#include "adapters/wyoming/wyoming_asr.hpp"
#include "tests/adapters/wyoming/wyoming_fixture.hpp"

namespace parlour::adapters::wyoming {
namespace {

// By a plug-in that uses it.
class ServerWatchTest : public test::WyomingTest {
protected:
  static bool nothing(Peer&, const Event&) {
    return true;
  }
};

TEST_F(ServerWatchTest, says_that_the_server_offers_something_else) {
  const test::WyomingServer server("tts", nothing);
  ASSERT_TRUE(start(wyoming_asr_factory(), server.options()));
  EXPECT_TRUE(says("does not offer the service 'asr'"));
  EXPECT_TRUE(host.wait([&] { return !host.is_available(); }, patience));
}

TEST_F(ServerWatchTest, says_that_the_server_is_silent) {
  const test::WyomingServer server("", nothing);
  ASSERT_TRUE(start(wyoming_asr_factory(), server.options()));
  EXPECT_TRUE(says("does not answer in time"));
}

TEST_F(ServerWatchTest,
       waits_for_the_answer_no_longer_if_it_says_other_things) {
  const test::WyomingServer server("", [](Peer& peer, const Event&) {
    while (peer.send({"pong"}))
      continue;
    return false;
  });
  auto options = server.options();
  options["connect-timeout"] = "300ms";
  ASSERT_TRUE(start(wyoming_asr_factory(), options));
  EXPECT_TRUE(says("does not answer in time"));
}

TEST_F(ServerWatchTest, says_that_it_is_no_wyoming_server) {
  const test::WyomingServer server("", [](Peer& peer, const Event&) {
    peer.write("HTTP/1.1 400 Bad Request\r\n\r\n");
    return false;
  });
  ASSERT_TRUE(start(wyoming_asr_factory(), server.options()));
  EXPECT_TRUE(says("does not speak the Wyoming protocol"));
}

} // namespace
} // namespace parlour::adapters::wyoming
