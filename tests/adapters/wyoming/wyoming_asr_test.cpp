#include "adapters/wyoming/wyoming_asr.hpp"
#include "tests/adapters/wyoming/wyoming_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class WyomingAsrTest : public test::WyomingTest {
protected:
  void use(test::WyomingServer::Serve serve) {
    server = std::make_unique<test::WyomingServer>("asr", std::move(serve));
    connect(wyoming_asr_factory(), server->options());
  }
  void speak(SessionId session = "s1") {
    for (int i = 0; i < 3; ++i)
      send("DoRecognition", {frame()}, session);
    send("Finish", {}, session);
  }
  // Tells how much it has heard.
  static bool count(Peer& peer, const Event& event) {
    auto& heard = peer.own<std::size_t>();
    if (event.type == "audio-chunk")
      heard += event.payload.size();
    if (event.type == "audio-stop")
      peer.send({"transcript", {{"text", " " + std::to_string(heard)}}});
    return true;
  }

  std::unique_ptr<test::WyomingServer> server;
};

TEST_F(WyomingAsrTest, has_a_turn_recognised) {
  use(count);
  speak();
  EXPECT_EQ(answer("RecognitionResult").at(0), Value("1920"));
  speak();
  EXPECT_EQ(answer("RecognitionResult").at(0), Value("1920"));
}

TEST_F(WyomingAsrTest, drops_what_was_cancelled) {
  use(count);
  send("DoRecognition", {frame()});
  send("Cancel");
  send("Finish");
  EXPECT_THAT(answer("Rejected").at(0).text(), HasSubstr("no speech"));
}

TEST_F(WyomingAsrTest, tells_partial_results) {
  use([](Peer& peer, const Event& event) {
    if (event.type == "audio-stop") {
      peer.send({"transcript-chunk", {{"text", "turn"}}});
      peer.send({"transcript-chunk", {{"text", " on"}}});
      peer.send({"transcript", {{"text", "turn on"}}});
    }
    return true;
  });
  speak();
  const auto partial = only(events_until("RecognitionResult"), "Partial");
  ASSERT_EQ(partial.size(), 2u);
  EXPECT_EQ(partial[1].params.at(0), Value("turn on"));
  EXPECT_EQ(partial[1].params.at(1), Value(2));
}

TEST_F(WyomingAsrTest, rejects_what_nobody_answers) {
  use([](Peer&, const Event&) { return true; });
  speak();
  EXPECT_THAT(answer("Rejected").at(0).text(), HasSubstr("not answer in time"));
}

TEST_F(WyomingAsrTest, rejects_what_is_cut_off) {
  use([](Peer& peer, const Event& event) {
    if (event.type == "audio-stop")
      peer.write("{\"type\": \"transcri");
    return event.type != "audio-stop";
  });
  speak();
  EXPECT_THAT(answer("Rejected").at(0).text(), HasSubstr("cut off"));
}

TEST_F(WyomingAsrTest, rejects_garbage_and_gigabytes) {
  use([](Peer& peer, const Event& event) {
    if (event.type == "audio-stop")
      peer.write("{\"type\": \"transcript\", \"data_length\": 1000000000}\n");
    return true;
  });
  speak();
  EXPECT_THAT(answer("Rejected").at(0).text(), HasSubstr("1000000000"));
}

TEST_F(WyomingAsrTest, rejects_a_turn_whose_connection_ended) {
  use([](Peer&, const Event& event) { return event.type != "transcribe"; });
  send("DoRecognition", {frame()});
  server->wait_for_connections(2);
  speak();
  EXPECT_THAT(answer("Rejected").at(0).text(), testing::Not(IsEmpty()));
}

TEST_F(WyomingAsrTest, answers_when_it_is_stopped) {
  use([](Peer&, const Event&) { return true; });
  speak();
  plugin->stop();
  EXPECT_THAT(answer("Rejected").at(0).text(), HasSubstr("stopped"));
}

TEST_F(WyomingAsrTest, refuses_what_is_no_audio) {
  use(count);
  send("DoRecognition", {Binary{"mp3", {}}});
  EXPECT_THAT(answer("Failed").at(0).text(), HasSubstr("no audio"));
  EXPECT_THAT(
      start(wyoming_asr_factory(), {{"address", "nowhere"}}).error().message,
      HasSubstr("'nowhere'"));
}

TEST_F(WyomingAsrTest, conforms) {
  const test::WyomingServer own("asr", count);
  EXPECT_THAT(
      conformance_errors(wyoming_asr_factory(),
                         {own.options(), Milliseconds(5'000), {}, {}, {}}),
      IsEmpty());
}

} // namespace
} // namespace parlour::adapters
