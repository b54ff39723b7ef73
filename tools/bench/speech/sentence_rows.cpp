#include "tools/bench/speech/sentence_rows.hpp"

#include <array>
#include <ostream>

#include <fmt/format.h>

#include "runtime/message/understanding.hpp"
#include "tools/bench/nlu/data_trial.hpp"
#include "tools/bench/speech/digit_strings.hpp"
#include "tools/bench/speech/figures.hpp"

namespace parlour::tools {

namespace {

constexpr std::size_t numbers_each = 50;

// Of sentences of one kind.
struct Counts {
  std::size_t said = 0;
  std::size_t by_text = 0;    // understood if it is typed
  std::size_t recognised = 0; // the recogniser did not reject it
  std::size_t understood = 0; // and something was understood
};

bool not_measured(const Error& error, const char* row, std::ostream& out) {
  out << fmt::format("{:<10} {}\n", row, to_string(error));
  return false;
}

Expected<HeardLine> say(const SentenceRows& rows, const std::string& line,
                        const std::string& voice) {
  const auto sound = rows.bank.speak(line, voice);
  if (!sound)
    return tl::make_unexpected(sound.error());
  auto heard = rows.listener.hear(**sound);
  if (heard && rows.trace)
    rows.out << fmt::format("  {}: {} -> {}{}\n", voice, line,
                            heard->rejected ? "rejected" : heard->text,
                            heard->acts.empty() ? ", nothing" : "");
  return heard;
}

Expected<Counts> count(const SentenceRows& rows,
                       const std::vector<std::string>& lines,
                       const std::string& voice) {
  Counts counts;
  for (const auto& line : lines) {
    const auto heard = say(rows, line, voice);
    if (!heard)
      return tl::make_unexpected(heard.error());
    ++counts.said;
    counts.by_text += !rows.listener.understand(line).empty();
    counts.recognised += !heard->rejected;
    counts.understood += !heard->acts.empty();
  }
  return counts;
}

} // namespace

NameOutcome name_outcome(const List& acts, const std::string& name) {
  for (const auto& act : acts) {
    const auto host = act[act_key::slots]["Host"];
    if (host.is_unknown() || host["unmatched"])
      continue;
    if (const auto* candidates = host[act_key::candidates].if_list())
      for (const auto& each : *candidates)
        if (each.text() == name)
          return NameOutcome::asked;
    return host[act_key::value].text() == name ? NameOutcome::right
                                               : NameOutcome::wrong;
  }
  return NameOutcome::nothing;
}

bool SentenceRows::names(const std::vector<std::string>& names) {
  for (const auto& voice : voices) {
    std::array<std::size_t, 4> counts{};
    for (const auto& name : names) {
      const auto heard = say(*this, "I am here to meet " + name + ".", voice);
      if (!heard)
        return not_measured(heard.error(), "names", out);
      ++counts.at(static_cast<std::size_t>(name_outcome(heard->acts, name)));
    }
    const auto [right, asked, wrong, nothing] = counts;
    out << fmt::format(
        "{:<10} {}: of {} names, right or asked back {} (right {}, asked {}), "
        "taken for somebody else {}, nobody {}; baseline: guessing {:.1f} %\n",
        "names", voice, names.size(),
        figure_at_least(percent(right + asked, names.size()), 90, " %"), right,
        asked, wrong, nothing, percent(1, names.size()));
  }
  return true;
}

bool SentenceRows::foreign(const Sentences& sentences) {
  for (const auto& voice : voices) {
    const auto foreign = count(*this, sentences.at("foreign"), voice);
    const auto belongs = count(*this, sentences.at("belongs"), voice);
    if (!foreign || !belongs)
      return not_measured(foreign ? belongs.error() : foreign.error(),
                          "foreign", out);
    out << fmt::format(
        "{:<10} {}: of {} foreign sentences rejected {}, by the recogniser "
        "alone {:.1f} %; of {} that belong accepted {}, recognised {:.1f} %; "
        "baseline: typed, {:.1f} % rejected and {:.1f} % accepted\n",
        "foreign", voice, foreign->said,
        figure_at_least(100 - percent(foreign->understood, foreign->said), 95,
                        " %"),
        100 - percent(foreign->recognised, foreign->said), belongs->said,
        figure_at_least(percent(belongs->understood, belongs->said), 97, " %"),
        percent(belongs->recognised, belongs->said),
        100 - percent(foreign->by_text, foreign->said),
        percent(belongs->by_text, belongs->said));
  }
  return true;
}

bool SentenceRows::digits(const std::filesystem::path& data,
                          const std::vector<std::string>& speakers) {
  const auto recordings = digit_recordings(data);
  if (data.empty() || recordings.empty()) {
    out << fmt::format("{:<10} not measured: --data names no folder with "
                       "github.com/Jakobovski/free-spoken-digit-dataset\n",
                       "digits");
    return true;
  }
  for (const auto& speaker : speakers) {
    std::size_t right = 0;
    const auto strings = digit_strings(recordings, speaker, numbers_each);
    for (const auto& string : strings) {
      const auto sound = sound_of(string);
      const auto heard =
          sound.and_then([&](const auto& line) { return listener.hear(line); });
      if (!heard)
        return not_measured(heard.error(), "digits", out);
      if (trace)
        out << fmt::format("  {}: {} -> {}\n", speaker, string.digits,
                           heard->text);
      right += digits_in(heard->text) == string.digits;
    }
    out << fmt::format(
        "{:<10} {}: of {} numbers of eight digits wholly right "
        "{}; baseline: guessing 0 %\n",
        "digits", speaker, strings.size(),
        figure_at_least(percent(right, strings.size()), 95, " %"));
  }
  return true;
}

} // namespace parlour::tools
