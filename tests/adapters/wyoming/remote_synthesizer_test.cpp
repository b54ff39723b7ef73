#include <atomic>

#include "adapters/wyoming/remote_synthesizer.hpp"
#include "adapters/wyoming/wyoming_tts.hpp"
#include "tests/adapters/wyoming/wyoming_fixture.hpp"

namespace parlour::adapters::wyoming {
namespace {

using testing::HasSubstr;

// By the plug-in that uses it.
class RemoteSynthesizerTest : public test::WyomingTest {
protected:
  void use(test::WyomingServer::Serve serve, Options more = {}) {
    server = std::make_unique<test::WyomingServer>("tts", std::move(serve));
    more.merge(server->options());
    connect(wyoming_tts_factory(), more);
  }

  std::unique_ptr<test::WyomingServer> server;
};

TEST_F(RemoteSynthesizerTest, says_what_the_server_complains_of) {
  use([](Peer& peer, const Event&) {
    peer.send({"error", {{"text", "no such voice"}}});
    return true;
  });
  send("Speak", {"one", 1});
  EXPECT_THAT(answer("Failed").at(0).text(), HasSubstr("no such voice"));
}

TEST_F(RemoteSynthesizerTest, fails_where_audio_is_cut_or_strange) {
  std::atomic<int> times = 0; // connections have threads of their own
  use([&](Peer& peer, const Event&) {
    if (++times == 1)
      peer.write("{\"type\": \"audio-chunk\", \"payload_length\": 100}\nxx");
    else
      peer.send({"audio-chunk", {{"rate", 1}}, "xx"});
    return times > 1;
  });
  send("Speak", {"one", 1});
  EXPECT_THAT(answer("Failed").at(0).text(), HasSubstr("cut off"));
  send("Speak", {"two", 2});
  EXPECT_THAT(answer("Failed").at(0).text(), HasSubstr("not 16 bit"));
}

TEST_F(RemoteSynthesizerTest, stops_although_the_server_is_silent) {
  use([](Peer&, const Event&) { return true; }, {{"answer-timeout", "1h"}});
  send("Speak", {"one", 1});
  server->wait_for_connections(2);
  send("Stop");
  answer("Finished");
  plugin->stop();
}

} // namespace
} // namespace parlour::adapters::wyoming
