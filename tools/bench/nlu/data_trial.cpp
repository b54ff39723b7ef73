#include "tools/bench/nlu/data_trial.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "runtime/base/clock.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

using adapters::nlu::NluEngine;
using adapters::nlu::Understanding;

namespace {

// The act about a topic, if there is one; else the first.
Value leading(const List& acts) {
  const auto found = std::ranges::find_if(
      acts, [](const auto& act) { return !act[act_key::topic].is_unknown(); });
  if (found != acts.end())
    return *found;
  return acts.empty() ? Value() : acts[0];
}

std::string without_article(std::string words) {
  for (const std::string article : {"the ", "a ", "an "})
    if (words.starts_with(article))
      return words.substr(article.size());
  return words;
}

// The words that filled a slot, or its value.
bool fits(const std::pair<std::string, std::string>& wanted,
          const std::string& name, const Value& slot) {
  return wanted.first == name &&
         (wanted.second == slot[act_key::value].text() ||
          without_article(wanted.second) ==
              without_article(slot[act_key::text].text()));
}

} // namespace

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100.0 * double(part) / double(whole);
}

// A slot is right if its name and its words are.
void SlotCount::add(const NluText& text, const Value& act) {
  wanted += text.slots.size();
  const auto* slots = act[act_key::slots].if_map();
  if (!slots)
    return;
  for (const auto& [name, slot] : slots->entries()) {
    ++found;
    right +=
        std::ranges::any_of(
            text.slots, [&](const auto& one) { return fits(one, name, slot); })
            ? 1U
            : 0U;
  }
}

double SlotCount::f1() const {
  // F1 = 2 PR / (P + R), with precision right / found and recall right /
  // wanted.
  return percent(2 * right, wanted + found);
}

void DataTrial::add(const std::vector<NluText>& all, const NluEngine& engine,
                    const NearestExample& baseline) {
  // A session always tells its time; without it, "tomorrow" is no date.
  const Value context(Map{{"now", *parse_timestamp(data_trial_time)}});
  const auto start = cpu_nanoseconds();
  for (const auto& text : all)
    add(text, engine.understand(text.text, context));
  seconds += (cpu_nanoseconds() - start) / 1e9;
  texts += all.size();
  for (const auto& text : all)
    nearest += !text.topic.empty() && baseline.topic(text.text) == text.topic
                   ? 1U
                   : 0U;
}

void DataTrial::add(const NluText& text, const Understanding& made) {
  if (text.topic.empty()) {
    ++strangers;
    rejected += made.acts.empty() ? 1U : 0U;
    return;
  }
  ++asked;
  const auto act = leading(made.acts);
  const auto& key =
      act[act_key::topic].is_unknown() ? act_key::act : act_key::topic;
  const bool is_right = act[key].text() == text.topic;
  right += is_right ? 1U : 0U;
  SlotCount own;
  own.add(text, act);
  const bool whole = own.wanted == own.found && own.wanted == own.right;
  frames += is_right && whole && made.acts.size() == 1 ? 1U : 0U;
  slots.wanted += own.wanted;
  slots.found += own.found;
  slots.right += own.right;
}

} // namespace parlour::tools
