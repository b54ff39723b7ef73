#include "adapters/wyoming/audio_events.hpp"
#include "adapters/wyoming/wyoming_tts.hpp"
#include "tests/adapters/wyoming/wyoming_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class WyomingTtsTest : public test::WyomingTest {
protected:
  void use(test::WyomingServer::Serve serve, Options more = {}) {
    server = std::make_unique<test::WyomingServer>("tts", std::move(serve));
    more.merge(server->options());
    connect(wyoming_tts_factory(), more);
  }
  // A second of sound, whatever the text is.
  static void speak(Peer& peer) {
    const nlohmann::json format = {
        {"rate", 22'050}, {"width", 2}, {"channels", 1}};
    peer.send({"audio-start", format});
    for (int i = 0; i < 10; ++i)
      peer.send({"audio-chunk", format, std::string(4'410, '\x10')});
    peer.send({"audio-stop"});
  }

  std::unique_ptr<test::WyomingServer> server;
};

TEST_F(WyomingTtsTest, has_texts_spoken) {
  Event order;
  use(
      [&](Peer& peer, const Event& event) {
        order = event;
        speak(peer);
        return true;
      },
      {{"voice", "anna"}, {"language", "de"}});
  send("Speak", {"one <two>", 3});
  const auto events = events_until("Finished");
  EXPECT_EQ(
      order.data,
      (nlohmann::json{{"text", "one <two>"},
                      {"voice", {{"name", "anna"}, {"language", "de"}}}}));
  EXPECT_EQ(duration(sound(events).size()), 1'000);
  EXPECT_THAT(marks(events), ElementsAre("one@0", "<two>@260"));
}

TEST_F(WyomingTtsTest, conforms) {
  const test::WyomingServer own("tts", [](Peer& peer, const Event&) {
    speak(peer);
    return true;
  });
  EXPECT_THAT(
      conformance_errors(wyoming_tts_factory(),
                         {own.options(), Milliseconds(5'000), {}, {}, {}}),
      IsEmpty());
}

} // namespace
} // namespace parlour::adapters
