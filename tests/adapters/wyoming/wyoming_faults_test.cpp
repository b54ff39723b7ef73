// Servers that misbehave, once: each component says so, and the next turn, text
// or word is served.
#include <atomic>

#include "adapters/wyoming/wyoming_asr.hpp"
#include "adapters/wyoming/wyoming_tts.hpp"
#include "adapters/wyoming/wyoming_wake.hpp"
#include "tests/adapters/wyoming/wyoming_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

struct Fault {
  std::string name;
  // Instead of serving an event. False ends the connection.
  std::function<bool(test::WyomingServer::Peer& peer)> happen;
  std::string complaint; // part of what is said of it
};

Fault writing(std::string name, std::string bytes, std::string complaint) {
  return {std::move(name),
          [bytes = std::move(bytes)](test::WyomingServer::Peer& peer) {
            return peer.write(bytes);
          },
          std::move(complaint)};
}

std::vector<Fault> all_faults() {
  using Peer = test::WyomingServer::Peer;
  return {
      {"cut", [](Peer&) { return false; }, ""},
      {"half_a_header",
       [](Peer& peer) {
         peer.write("{\"type\": \"transcr");
         return false;
       },
       "cut off"},
      {"half_a_payload",
       [](Peer& peer) {
         peer.write("{\"type\": \"audio-chunk\", \"payload_length\": 9}\nx");
         return false;
       },
       "cut off"},
      writing("garbage", "\x7f\xff\n\x01\x02\n", "does not speak"),
      writing("gigabyte",
              "{\"type\": \"audio-chunk\", \"payload_length\": 1073741824}\n",
              "1073741824"),
      writing("gigabyte_of_data",
              "{\"type\": \"info\", \"data_length\": 1073741824}\n",
              "1073741824"),
      writing("deep",
              "{\"type\": \"info\", \"data\": " + std::string(100'000, '[') +
                  "\n",
              "does not speak"),
      writing("error",
              "{\"type\": \"error\", \"data\": {\"text\": \"busy\"}}\n",
              "busy")};
}

// One that says nothing is no fault where nothing need be said.
std::vector<Fault> faults_of_answers() {
  auto all = all_faults();
  all.push_back({"silent",
                 [](test::WyomingServer::Peer& peer) {
                   peer.wait_for_end();
                   return false;
                 },
                 "in time"});
  return all;
}

std::string name_of(const testing::TestParamInfo<Fault>& info) {
  return info.param.name;
}

class WyomingFaultTest : public test::WyomingTest,
                         public testing::WithParamInterface<Fault> {
protected:
  // The first event of the type meets the fault.
  void use(const PluginFactory& factory, const std::string& service,
           const std::string& type, test::WyomingServer::Serve serve) {
    server = std::make_unique<test::WyomingServer>(
        service, [this, type, serve](Peer& peer, const Event& event) {
          if (event.type == type && !happened.exchange(true))
            return GetParam().happen(peer);
          return serve(peer, event);
        });
    auto options = server->options();
    // Only silence is told by the time; all else may take as long as it takes.
    if (GetParam().name == "silent")
      options["connect-timeout"] = "300ms";
    options["answer-timeout"] = GetParam().name == "silent" ? "1s" : "10s";
    connect(factory, options);
  }
  void expect_complaint(const std::string& command) {
    EXPECT_THAT(answer(command).at(0).text(), HasSubstr(GetParam().complaint));
    EXPECT_TRUE(happened);
  }

  std::atomic<bool> happened = false;
  std::unique_ptr<test::WyomingServer> server;
};

class WyomingAsrFaultTest : public WyomingFaultTest {};

TEST_P(WyomingAsrFaultTest, rejects_the_turn_and_goes_on) {
  use(wyoming_asr_factory(), "asr", "audio-stop",
      [](Peer& peer, const Event& event) {
        if (event.type == "audio-stop")
          peer.send({"transcript", {{"text", "well"}}});
        return true;
      });
  auto speak = [this] {
    send("DoRecognition", {frame()});
    send("Finish");
  };
  speak();
  expect_complaint("Rejected");
  speak();
  EXPECT_EQ(answer("RecognitionResult").at(0), Value("well"));
}

INSTANTIATE_TEST_SUITE_P(Wyoming, WyomingAsrFaultTest,
                         testing::ValuesIn(faults_of_answers()), name_of);

class WyomingTtsFaultTest : public WyomingFaultTest {};

TEST_P(WyomingTtsFaultTest, fails_the_text_and_goes_on) {
  use(wyoming_tts_factory(), "tts", "synthesize", [](Peer& peer, const Event&) {
    peer.send({"audio-chunk",
               {{"rate", 16'000}, {"width", 2}, {"channels", 1}},
               std::string(640, '\0')});
    return peer.send({"audio-stop"});
  });
  send("Speak", {"one", 1});
  expect_complaint("Failed");
  send("Speak", {"two", 2});
  EXPECT_EQ(answer("Finished").at(0), Value(2));
}

INSTANTIATE_TEST_SUITE_P(Wyoming, WyomingTtsFaultTest,
                         testing::ValuesIn(faults_of_answers()), name_of);

class WyomingWakeFaultTest : public WyomingFaultTest {};

TEST_P(WyomingWakeFaultTest, says_so_and_listens_again) {
  use(wyoming_wake_factory(), "wake", "audio-chunk",
      [](Peer& peer, const Event& event) {
        if (event.type == "audio-chunk")
          peer.send({"detection", {{"name", "robot"}}});
        return true;
      });
  send("Process", {frame()});
  expect_complaint("Failed");
  // It tries again after a pause.
  auto found = [&] {
    for (const auto& event : host.take_events())
      if (event.command == "Keyword")
        return true;
    return false;
  };
  bool is_found = false;
  for (int i = 0; i < 6'000 && !is_found; ++i) {
    send("Process", {frame()});
    is_found = host.wait(found, Milliseconds(10));
  }
  EXPECT_TRUE(is_found);
}

INSTANTIATE_TEST_SUITE_P(Wyoming, WyomingWakeFaultTest,
                         testing::ValuesIn(all_faults()), name_of);

// -- servers that take nothing, or say no end ---------------------------------

class SlowWyomingTest : public test::WyomingTest {
protected:
  void use(const PluginFactory& factory, const std::string& service,
           test::WyomingServer::Serve serve, Options more = {}) {
    server = std::make_unique<test::WyomingServer>(service, std::move(serve));
    more.merge(server->options());
    connect(factory, more);
  }
  // Several times what the client and the system keep.
  void speak(const std::string& command, int seconds = 150) {
    const auto second =
        pcm_value(std::vector<Sample>(std::size_t{speech_rate}, 100));
    for (int i = 0; i < seconds; ++i)
      send(command, {second});
  }
  static bool stall(Peer& peer, const Event& event) {
    if (event.type == "audio-start")
      peer.stall();
    return true;
  }

  std::unique_ptr<test::WyomingServer> server;
};

TEST_F(SlowWyomingTest, cannot_recognise_what_it_does_not_take) {
  use(wyoming_asr_factory(), "asr", stall);
  speak("DoRecognition");
  send("Finish");
  EXPECT_THAT(answer("Rejected").at(0).text(), HasSubstr("too little"));
  // Silence costs nothing: the next turn is as good as the first.
  speak("DoRecognition", 1);
  send("Finish");
  EXPECT_THAT(answer("Rejected").at(0).text(), HasSubstr("in time"));
}

TEST_F(SlowWyomingTest, finds_no_word_in_what_it_does_not_take) {
  use(wyoming_wake_factory(), "wake", stall);
  speak("Process");
  EXPECT_THAT(answer("Failed").at(0).text(), HasSubstr("too little"));
}

TEST_F(SlowWyomingTest, does_not_recognise_forever) {
  use(wyoming_asr_factory(), "asr", [](Peer& peer, const Event& event) {
    if (event.type == "audio-stop")
      while (peer.send({"transcript-chunk", {{"text", "and "}}}))
        continue;
    return true;
  });
  // Partial results have an end, too.
  send("DoRecognition", {frame()});
  send("Finish");
  events_until("Partial", 1'000);
  server.reset();
  EXPECT_LE(only(events_until("Rejected"), "Partial").size(), 250u);
}

TEST_F(SlowWyomingTest, answers_turns_in_its_own_order) {
  std::atomic<int> finished = 0;
  auto serve = [&](Peer& peer, const Event& event) {
    // Before it is asked, too.
    if (event.type == "audio-chunk") {
      peer.send({"transcript", {{"text", "early"}}});
      peer.send({"transcript-chunk", {{"text", "a part"}}});
    }
    if (event.type == "audio-stop") {
      peer.send({"audio-stop"});
      peer.send({"transcript", {{"text", std::to_string(++finished)}}});
      peer.send({"transcript", {{"text", "late"}}});
    }
    return true;
  };
  use(wyoming_asr_factory(), "asr", serve, {{"answer-timeout", "10s"}});
  for (const auto* session : {"s1", "s2"}) {
    send("DoRecognition", {frame()}, session);
    answer("Partial");
    send("Finish", {}, session);
    const auto heard = answer("RecognitionResult").at(0);
    EXPECT_EQ(heard, Value(std::to_string(finished)));
  }
}

TEST_F(SlowWyomingTest, does_not_speak_forever) {
  use(wyoming_tts_factory(), "tts", [](Peer& peer, const Event&) {
    const nlohmann::json format = {
        {"rate", 16'000}, {"width", 2}, {"channels", 1}};
    while (peer.send({"audio-chunk", format, std::string(32'000, '\x10')}))
      continue;
    return false;
  });
  send("Speak", {"one", 1});
  EXPECT_THAT(answer("Failed").at(0).text(), HasSubstr("stop talking"));
}

TEST_F(SlowWyomingTest, has_no_more_turns_than_it_can) {
  use(wyoming_asr_factory(), "asr", [](Peer&, const Event&) { return true; });
  for (int i = 0; i < 65; ++i)
    send("DoRecognition", {frame()}, "s" + std::to_string(i));
  send("Finish", {}, "s64");
  EXPECT_THAT(answer("Rejected").at(0).text(), HasSubstr("too many turns"));
}

} // namespace
} // namespace parlour::adapters
