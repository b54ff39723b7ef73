#include "tools/bench/nlu/data_trial.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

using adapters::nlu::NluEngine;
using adapters::nlu::Understanding;

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100.0 * double(part) / double(whole);
}

// A slot is right if its name and its value are.
void SlotCount::add(const NluText& text, const Understanding& made) {
  wanted += text.slots.size();
  const auto slots = made.acts.empty() ? Value() : made.acts[0]["slots"];
  if (!slots.if_map())
    return;
  for (const auto& [name, slot] : slots.if_map()->entries()) {
    ++found;
    right += std::ranges::count(text.slots,
                                std::pair(name, slot["value"].text())) > 0
                 ? 1U
                 : 0U;
  }
}

double SlotCount::f1() const {
  // F1 = 2 PR / (P + R), with precision right / found and recall right /
  // wanted.
  return percent(2 * right, wanted + found);
}

DataTrial::DataTrial(const std::vector<NluText>& texts,
                     const NluEngine& engine) {
  const auto start = cpu_nanoseconds();
  for (const auto& text : texts)
    add(text, engine.understand(text.text));
  seconds = (cpu_nanoseconds() - start) / 1e9;
  std::ranges::sort(scores);
}

double DataTrial::limit() const {
  // The fifth percentile: scores are sorted.
  return scores.empty() ? 0 : scores[scores.size() / 20];
}

void DataTrial::add(const NluText& text, const Understanding& made) {
  if (text.topic.empty()) {
    strangers.push_back(made.score);
    return;
  }
  ++asked;
  scores.push_back(made.score);
  slots.add(text, made);
  right += !made.acts.empty() && made.acts[0]["topic"].text() == text.topic
               ? 1U
               : 0U;
}

double percent_below(const std::vector<double>& scores, double limit) {
  const auto below = std::ranges::count_if(
      scores, [limit](double score) { return score < limit; });
  return percent(static_cast<std::size_t>(below), scores.size());
}

} // namespace parlour::tools
