// What the three detectors find in the same streams: sentences of two flite
// voices in babble. Prints the figures of docs/benchmarks.md. SileroVAD with
// its real program and weights; left out where `tools/dependencies ears` has
// not been called.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "adapters/vad/adaptive_vad.hpp"
#include "adapters/vad/silero_vad.hpp"
#include "adapters/vad/webrtc_vad.hpp"
#include "runtime/plugin/test_host.hpp"
#include "tests/support/audio/voices.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters {
namespace {

constexpr int sentences = 60;

struct Stream {
  test::Sound sound = test::silence(3'000);
  std::vector<std::pair<std::int64_t, std::int64_t>> spoken; // ms
};

Stream stream_of_sentences() {
  constexpr std::array texts{"Is there a coffee shop on this floor?",
                             "I am here to meet Doctor Ho.",
                             "Please call a taxi.", "How about the food court?",
                             "My appointment is at half past ten."};
  Stream stream;
  for (std::int64_t i = 0; i < sentences; ++i) {
    const auto said = adapters::without_silence(
        test::spoken(texts[static_cast<std::size_t>(i) % texts.size()],
                     i % 2 ? "slt" : "rms"));
    const auto begin = duration(stream.sound.size());
    const auto loud = test::at_level(said, test::speech_level_of(said), -26);
    stream.sound.insert(stream.sound.end(), loud.begin(), loud.end());
    stream.spoken.emplace_back(begin, duration(stream.sound.size()));
    stream.sound.resize(stream.sound.size() +
                        test::samples_in(1'000 + 130 * (i % 8)));
  }
  return stream;
}

// Found, started within 100 ms, merged, made up.
std::string judged(PluginFactory factory, const Options& options,
                   const Stream& stream) {
  TestHost host;
  const auto plugin = factory.create();
  if (!plugin->start(host, options))
    return "is not there";
  std::vector<std::pair<std::int64_t, std::int64_t>> found;
  for (std::size_t at = 0; at < stream.sound.size(); at += frame_samples) {
    Message frame;
    frame.session = "one";
    frame.command = "Process";
    frame.params = {pcm_value(
        std::span(stream.sound)
            .subspan(at, std::min(frame_samples, stream.sound.size() - at)))};
    plugin->receive(frame);
    for (const auto& event : host.take_events()) {
      const auto position = event.params.at(0).integer_or(0);
      if (event.command == "SpeechStarted")
        found.emplace_back(position, duration(stream.sound.size()));
      else if (!found.empty())
        found.back().second = position;
    }
  }
  plugin->stop();
  int heard = 0, in_time = 0, merged = 0, made_up = 0;
  const auto meet = [](const auto& one, const auto& other) {
    return one.first < other.second && other.first < one.second;
  };
  for (const auto& sentence : stream.spoken)
    for (const auto& each : found)
      if (meet(each, sentence)) {
        ++heard;
        in_time += std::abs(each.first - sentence.first) <= 100;
        break;
      }
  for (const auto& each : found) {
    const auto holds =
        std::ranges::count_if(stream.spoken, [&](const auto& sentence) {
          return meet(each, sentence);
        });
    merged += holds > 1;
    made_up += holds == 0;
  }
  return std::to_string(heard) + " found, " + std::to_string(in_time) +
         " in time, " + std::to_string(merged) + " merged, " +
         std::to_string(made_up) + " made up";
}

TEST(DetectorsMeasured, InBabble) {
  const std::filesystem::path program =
      test::source_path("tools/agents/moonshine/moonshine.mjs");
  if (!test::can_speak() ||
      !std::filesystem::exists(program.parent_path() / "node_modules"))
    GTEST_SKIP() << "needs flite and `tools/dependencies ears`";
  const auto clean = stream_of_sentences();
  const auto noise = test::babble(10, 30'000, -30);
  for (const auto distance : {100, 20, 10}) {
    auto stream = clean;
    if (distance < 100)
      test::add_noise(stream.sound, noise, distance, 8);
    const auto adaptive = judged(adaptive_vad_factory(), {}, stream);
    const auto silero =
        judged(silero_vad_factory({program}), {{"one-by-one", "true"}}, stream);
    std::cout << distance << " dB\n  AdaptiveVAD " << adaptive
              << "\n  WebRtcVAD   " << judged(webrtc_vad_factory(), {}, stream)
              << "\n  SileroVAD   " << silero << '\n';
    EXPECT_EQ(adaptive.substr(0, 8), "60 found");
    EXPECT_EQ(silero.substr(0, 8), "60 found");
  }
}

} // namespace
} // namespace parlour::adapters
