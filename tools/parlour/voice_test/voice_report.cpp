#include "tools/parlour/voice_test/voice_report.hpp"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>

namespace parlour::tools {

namespace {

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const auto& text : texts)
    all += (all.empty() ? "" : " | ") + (text.empty() ? "(rejected)" : text);
  return all.empty() ? "(nothing)" : all;
}

void print_pair(std::ostream& out, const char* what,
                const std::vector<std::string>& expected,
                const std::vector<std::string>& found) {
  if (expected == found)
    return;
  out << fmt::format("  {:<10} {}\n  {:<10} {}\n", what, joined(found),
                     "  by text", joined(expected));
}

void print_latencies(std::ostream& out, const Row& row) {
  for (const auto& took : row.latencies)
    out << fmt::format("  {:<10} {} ms until it was over, {} ms waited, {} ms "
                       "computed\n",
                       "time", took.pause.count(), took.waiting.count(),
                       took.computing.count());
}

void print_row(std::ostream& out, const VoiceResult& result, std::size_t i,
               bool all) {
  const auto& row = result.found[i];
  const auto& expected = result.expected[i];
  if (!all && row.is_as(expected))
    return;
  out << fmt::format("{}:{}: by {}\n  {:<10} {}\n  {:<10} {}\n", result.file,
                     row.line, result.voice, "said", joined(row.said), "heard",
                     joined(row.heard));
  print_pair(out, "understood", expected.understood, row.understood);
  print_pair(out, "answered", expected.answers, row.answers);
  if (all)
    print_latencies(out, row);
}

double percent(std::size_t part, std::size_t whole) {
  return whole == 0
             ? 0
             : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

void print_rows(std::ostream& out, const std::vector<VoiceResult>& results,
                bool all) {
  for (const auto& result : results) {
    for (std::size_t i = 0; i < result.found.size(); ++i)
      print_row(out, result, i, all);
    if (!result.trouble.empty())
      out << result.file << ": not held by voice: " << result.trouble << '\n';
  }
}

void print_scores(std::ostream& out, const std::vector<VoiceResult>& results,
                  const VoiceWish& wish) {
  out << fmt::format(
      "{:<10} {:<10} {:>5} {:>7} {:>4} {:>4} {:>4}  {:>5} {:>10} "
      "{:>8}  {:>11} {:>6}\n",
      "voice", "noise", "words", "wrong", "sub", "ins", "del", "turns",
      "understood", "answered", "latency p50", "p95");
  for (const auto& voice : wish.voices) {
    const auto score = score_of(results, voice);
    out << fmt::format(
        "{:<10} {:<10} {:>5} {:>5.1f} % {:>4} {:>4} {:>4}  {:>5} {:>8.1f} % "
        "{:>6.1f} %  {:>8} ms {:>3} ms\n",
        voice, to_string(wish.noise), score.words.words, score.words.rate(),
        score.words.substitutions, score.words.insertions,
        score.words.deletions, score.rows, percent(score.right, score.rows),
        percent(score.answered, score.rows),
        percentile(score.latencies, 50).count(),
        percentile(score.latencies, 95).count());
  }
}

bool all_as_by_text(const std::vector<VoiceResult>& results) {
  std::size_t rows = 0;
  for (const auto& result : results)
    for (std::size_t i = 0; i < result.expected.size(); ++i, ++rows)
      if (i >= result.found.size() ||
          !result.found[i].is_as(result.expected[i]))
        return false;
  return rows > 0;
}

} // namespace parlour::tools
