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

} // namespace
} // namespace parlour::adapters::wyoming
