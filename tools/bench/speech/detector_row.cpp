#include "tools/bench/speech/detector_row.hpp"

#include <ostream>

#include <fmt/format.h>

#include "tools/bench/speech/figures.hpp"
#include "tools/parlour/application/plugins/plugin_calls.hpp"
#include "tools/parlour/speech/application_host.hpp"

namespace parlour::tools {

namespace {

using adapters::frame_samples;
using adapters::frame_time;
using adapters::Sound;

constexpr std::int64_t pause = 1'200; // ms
// Between the lines (-26 dB) and the babble (-36 dB).
constexpr double fixed_level = -32;

std::int64_t position_of(const Message& event) {
  return event.params.empty() ? 0 : event.params[0].integer_or(0);
}

Expected<std::vector<Segment>> detected(const Application& application,
                                        const Sound& sound) {
  const auto* component = first_of_role(application.composition, "VAD");
  if (!component)
    return fail(ErrorKind::settings, "there is no component of the role VAD");
  ApplicationHost host(application);
  auto plugin = start_plugin(component->factory, host, component->options);
  if (!plugin)
    return tl::make_unexpected(plugin.error());
  std::vector<Segment> found;
  Message frame;
  frame.command = "Process";
  frame.session = "bench";
  for (std::size_t at = 0; at + frame_samples <= sound.size();
       at += frame_samples) {
    frame.params = {
        adapters::pcm_value(std::span(sound).subspan(at, frame_samples)),
        adapters::duration(at)};
    (*plugin)->receive(frame);
    host.advance(Milliseconds(frame_time));
    for (const auto& event : host.take_events())
      if (event.command == "SpeechStarted")
        found.push_back({position_of(event), adapters::duration(sound.size())});
      else if (event.command == "SpeechEnded" && !found.empty())
        found.back().end = position_of(event);
  }
  stop_plugin(**plugin);
  return found;
}

std::string text_of(const SegmentScore& score) {
  const auto& delays = score.delays;
  const auto p95 = delays.empty() ? 0 : delays[(delays.size() - 1) * 95 / 100];
  return fmt::format("start within {} at p95, missed {}, merged {}, false "
                     "alarms {}",
                     figure_at_most(double(p95), 100, " ms"), score.missed,
                     score.merged, score.false_alarms);
}

} // namespace

SpokenRow in_a_row(const std::vector<const Sound*>& lines, const Sound& noise) {
  SpokenRow made;
  auto& sound = made.sound;
  sound.resize(adapters::samples_in(2 * pause));
  for (const auto* line : lines) {
    const auto begin = sound.size();
    sound.insert(sound.end(), line->begin(), line->end());
    made.said.push_back(
        {adapters::duration(begin), adapters::duration(sound.size())});
    sound.resize(sound.size() + adapters::samples_in(pause));
  }
  for (std::size_t at = 0; at < sound.size() && !noise.empty();
       at += noise.size())
    adapters::add(sound, noise, at);
  return made;
}

bool detector_row(const Application& spoken, SpeechBank& bank,
                  const std::vector<std::string>& lines,
                  const std::string& voice, std::ostream& out) {
  const auto noise = make_noise({NoiseWish::Kind::babble, 10}, voice, bank);
  std::vector<const Sound*> sounds;
  for (const auto& line : lines)
    if (const auto sound = bank.speak(line, voice))
      sounds.push_back(*sound);
  const auto row = noise ? in_a_row(sounds, *noise) : SpokenRow();
  const auto found =
      noise.and_then([&](const Sound&) { return detected(spoken, row.sound); });
  if (!found) {
    out << fmt::format("{:<10} {}\n", "detector", to_string(found.error()));
    return false;
  }
  out << fmt::format(
      "{:<10} {}: {} lines in babble at 10 dB, {}; baseline, what is louder "
      "than {} dB: {}\n",
      "detector", voice, row.said.size(),
      text_of(compare_segments(row.said, *found)), fixed_level,
      text_of(
          compare_segments(row.said, by_fixed_level(row.sound, fixed_level))));
  return true;
}

} // namespace parlour::tools
