#include "tools/bench/speech/load_row.hpp"

#include <chrono>
#include <ostream>

#include <fmt/format.h>

#include "tools/bench/speech/figures.hpp"
#include "tools/bench/speech/listener.hpp"
#include "tools/bench/speech/process_figures.hpp"

namespace parlour::tools {

namespace {

using SteadyClock = std::chrono::steady_clock;

double seconds_since(SteadyClock::time_point begin) {
  return std::chrono::duration<double>(SteadyClock::now() - begin).count();
}

} // namespace

bool load_row(const Application& spoken, SpeechBank& bank, bool told,
              const std::vector<std::string>& lines, const std::string& voice,
              std::ostream& out) {
  std::vector<const adapters::Sound*> sounds;
  double audio = 0; // seconds
  for (const auto& line : lines)
    if (const auto sound = bank.speak(line, voice)) {
      sounds.push_back(*sound);
      audio += double((*sound)->size()) / adapters::speech_rate;
    }
  const auto before = process_figures();
  const auto begin = SteadyClock::now();
  auto listener = Listener::start(spoken, told);
  auto trouble = listener ? std::optional<Error>() : listener.error();
  double ready = 0;
  double cpu = 0;
  for (std::size_t i = 0; i < sounds.size() && !trouble; ++i) {
    const auto heard = (*listener)->hear(*sounds[i]);
    if (!heard)
      trouble = heard.error();
    if (i > 0)
      continue;
    ready = seconds_since(begin);
    cpu = process_figures().cpu_seconds;
    audio -= double(sounds[0]->size()) / adapters::speech_rate;
  }
  if (trouble) {
    out << fmt::format("{:<10} {}\n", "load", to_string(*trouble));
    return false;
  }
  const auto after = process_figures();
  out << fmt::format(
      "{:<10} first line recognised {} after the start; {}; CPU time, share "
      "of what is spoken, {}; baseline: the bench without it, {:.0f} MB\n",
      "load", figure_at_most(ready, 1.5, " s"),
      figure_at_most(after.mebibytes - before.mebibytes, 60, " MB"),
      figure_at_most(100 * (after.cpu_seconds - cpu) / audio, 10, " %"),
      before.mebibytes);
  return true;
}

} // namespace parlour::tools
