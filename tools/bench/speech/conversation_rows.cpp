#include "tools/bench/speech/conversation_rows.hpp"

#include <algorithm>
#include <map>
#include <ostream>

#include <fmt/format.h>

#include "tools/bench/nlu/data_trial.hpp"
#include "tools/bench/speech/figures.hpp"

namespace parlour::tools {

double always_the_same(const std::vector<VoiceResult>& results) {
  std::map<std::vector<std::string>, std::size_t> counts;
  std::size_t rows = 0;
  std::size_t most = 0;
  for (const auto& result : results)
    for (const auto& row : result.expected) {
      ++rows;
      most = std::max(most, ++counts[row.understood]);
    }
  return percent(most, rows);
}

Milliseconds reaction(const std::vector<Latency>& latencies, int percent) {
  std::vector<Latency> beyond;
  for (const auto& each : latencies)
    beyond.push_back({Milliseconds(0), each.waiting, each.computing});
  std::ranges::sort(beyond, {}, &Latency::all);
  return percentile(beyond, percent);
}

void print_conversations(const ConversationRow& row, const VoiceWish& wish,
                         const std::vector<VoiceResult>& results,
                         std::ostream& out) {
  for (const auto& voice : wish.voices) {
    const auto score = score_of(results, voice);
    out << fmt::format(
        "{:<10} {}: {} turns, {} words; word errors {}, understood as by text "
        "{}, also answered so {:.1f} %; from the decision to the first sound, "
        "p50 {} ms, p95 {}\n",
        row.name, voice, score.rows, score.words.words,
        figure_at_most(score.words.rate(), row.word_errors, " %"),
        figure_at_least(percent(score.right, score.rows), row.understood, " %"),
        percent(score.answered, score.rows),
        reaction(score.latencies, 50).count(),
        figure_at_most(double(reaction(score.latencies, 95).count()), 150,
                       " ms"));
  }
  out << fmt::format("{:<10} baseline: who hears nothing has 100 % word "
                     "errors; who always understands the most frequent "
                     "turn is right in {:.1f} %\n",
                     row.name, always_the_same(results));
}

} // namespace parlour::tools
