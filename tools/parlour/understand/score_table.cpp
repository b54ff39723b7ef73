#include "tools/parlour/understand/score_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "runtime/message/understanding.hpp"

namespace parlour::tools {

namespace {

constexpr std::size_t shown = 10;

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100.0 * double(part) / double(whole);
}

std::string share(std::size_t part, std::size_t whole) {
  return fmt::format("{:.1f} % ({} of {})", percent(part, whole), part, whole);
}

// The first act about a topic; else the first; unknown if there is none.
Value leading(const List& acts) {
  for (const auto& act : acts)
    if (!act[act_key::topic].is_unknown())
      return act;
  return acts.empty() ? Value() : acts[0];
}

// "nothing" where nothing was understood.
std::string intent_of_act(const Value& act) {
  if (!act[act_key::topic].is_unknown())
    return act[act_key::topic].text();
  return act.is_unknown() ? "nothing" : act[act_key::act].text();
}

std::string value_of(const Value& slot) {
  return slot.if_map() ? slot[act_key::value].text() : slot.text();
}

// How many of the act's slots are marked so.
std::size_t right_slots(const MarkedSentence& sentence, const Value& act) {
  std::size_t right = 0;
  for (const auto& [name, value] : sentence.slots.entries()) {
    const auto& slot = act[act_key::slots][name];
    right += !slot.is_unknown() && value_of(slot) == value.text() ? 1U : 0U;
  }
  return right;
}

std::size_t slots_of(const Value& act) {
  const auto* slots = act[act_key::slots].if_map();
  return slots ? slots->size() : 0;
}

bool is_frame_right(const MarkedSentence& sentence, const List& acts,
                    const Value& act) {
  const auto topics = std::ranges::count_if(
      acts, [](const auto& one) { return !one[act_key::topic].is_unknown(); });
  const bool act_right =
      sentence.act.empty() || sentence.act == act[act_key::act].text();
  return topics <= 1 && act_right && slots_of(act) == sentence.slots.size() &&
         right_slots(sentence, act) == sentence.slots.size();
}

std::string shown_frame(const std::string& intent, const Map& slots) {
  std::string made = intent;
  for (const auto& [name, slot] : slots.entries())
    made += " " + name + "=\"" + value_of(slot) + "\"";
  return made;
}

std::string shown_act(const Value& act) {
  const auto* slots = act[act_key::slots].if_map();
  return shown_frame(intent_of_act(act), slots ? *slots : Map());
}

// The largest first.
template <class Key>
std::vector<std::pair<Key, std::size_t>>
by_count(const std::map<Key, std::size_t>& counts) {
  std::vector<std::pair<Key, std::size_t>> sorted(counts.begin(), counts.end());
  std::ranges::stable_sort(sorted, [](const auto& left, const auto& right) {
    return left.second > right.second;
  });
  return sorted;
}

} // namespace

void ScoreTable::add(const MarkedSentence& sentence, const List& acts,
                     double score) {
  const auto act = leading(acts);
  const auto wanted = intent_of(sentence);
  const auto made = intent_of_act(act);
  const bool intent = wanted == made;
  const bool frame = intent && is_frame_right(sentence, acts, act);
  ++sentences_;
  ++by_intent_[wanted];
  bare_[wanted] += sentence.slots.empty() ? 1U : 0U;
  intents_ += intent ? 1U : 0U;
  frames_ += frame ? 1U : 0U;
  nothing_ += wanted == "nothing" ? 1U : 0U;
  rejected_ += wanted == "nothing" && intent ? 1U : 0U;
  add_slots(sentence, act);
  if (!intent)
    ++confused_[{wanted, made}];
  if (!frame)
    mistakes_.push_back(
        {score,
         fmt::format("line {}, {:.2f}: \"{}\" is {}, not {}", sentence.line,
                     score, sentence.text, shown_frame(wanted, sentence.slots),
                     shown_act(act))});
}

void ScoreTable::add_slots(const MarkedSentence& sentence, const Value& act) {
  wanted_ += sentence.slots.size();
  found_ += slots_of(act);
  right_ += right_slots(sentence, act);
}

std::vector<std::string> ScoreTable::lines() const {
  std::vector<std::string> made{fmt::format("sentences {}", sentences_)};
  if (sentences_ == 0)
    return made;
  const auto frequent = by_count(by_intent_)[0];
  made.push_back(fmt::format("intent    {}; always {}: {:.1f} %",
                             share(intents_, sentences_), frequent.first,
                             percent(frequent.second, sentences_)));
  if (nothing_ > 0)
    made.push_back("rejected  " + share(rejected_, nothing_));
  if (wanted_ + found_ > 0)
    made.push_back(fmt::format(
        "slots     F1 {:.1f} (precision {:.1f}, recall {:.1f}); none: 0.0",
        percent(2 * right_, wanted_ + found_), percent(right_, found_),
        percent(right_, wanted_)));
  made.push_back(fmt::format("frames    {}; always {} without slots: {:.1f} %",
                             share(frames_, sentences_), frequent.first,
                             percent(bare_.at(frequent.first), sentences_)));
  const auto confused = by_count(confused_);
  for (std::size_t at = 0; at < std::min(shown, confused.size()); ++at)
    made.push_back(fmt::format("confused  {} times {} was taken for {}",
                               confused[at].second, confused[at].first.first,
                               confused[at].first.second));
  auto worst = mistakes_;
  std::ranges::stable_sort(worst, std::greater(), &Mistake::score);
  for (std::size_t at = 0; at < std::min(shown, worst.size()); ++at)
    made.push_back("worst     " + worst[at].text);
  return made;
}

} // namespace parlour::tools
