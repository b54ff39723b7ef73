#include "script/dialogue/agenda/output_queue.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace parlour::dialogue {

namespace {

// Answers are never withdrawn, and what is said in passing neither (engine
// rule 3).
bool may_be_withdrawn(const Output& output) {
  return output.act == OutputAct::question ||
         output.act == OutputAct::reprompt || output.act == OutputAct::resume;
}

} // namespace

OutputId OutputQueue::push(Output output) {
  output.id = ++last_id_;
  entries_.push_back(std::move(output));
  return last_id_;
}

void OutputQueue::word(OutputId id, std::string text) {
  auto found = std::find_if(entries_.begin(), entries_.end(),
                            [&](const Output& o) { return o.id == id; });
  if (found == entries_.end())
    return;
  if (text.empty()) {
    entries_.erase(found);
    return;
  }
  found->text = std::move(text);
  found->state = OutputState::pending;
}

bool OutputQueue::has(OutputId id) const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Output& o) { return o.id == id; });
}

OutputQueue::Released OutputQueue::release(const Which& begun) {
  auto withdrawn = withdraw(begun);
  return {release_pending(), std::move(withdrawn)};
}

std::vector<Output> OutputQueue::withdraw_questions() {
  return withdraw([](const Output&) { return true; });
}

// The order of what stays is kept, and so is the order of what is withdrawn, in
// which the trace shows it.
std::vector<Output> OutputQueue::withdraw(const Which& which) {
  const auto first = std::stable_partition(
      entries_.begin(), entries_.end(), [&](const Output& output) {
        return !may_be_withdrawn(output) || !which(output);
      });
  std::vector<Output> withdrawn(std::make_move_iterator(first),
                                std::make_move_iterator(entries_.end()));
  entries_.erase(first, entries_.end());
  for (auto& output : withdrawn)
    output.state = OutputState::withdrawn;
  return withdrawn;
}

// Everything up to the first entry that waits for its words. The first release
// of a robot turn forgets the turn before: "repeat" says what was said since.
std::span<const Output> OutputQueue::release_pending() {
  const auto waits =
      std::find_if(entries_.begin(), entries_.end(), [](const Output& output) {
        return output.state != OutputState::pending;
      });
  if (waits == entries_.begin())
    return {};
  if (std::exchange(fresh_turn_, false)) {
    last_turn_.clear();
    cut_.clear();
  }
  forget_what_is_too_much();
  const auto before = last_turn_.size();
  for (auto entry = entries_.begin(); entry != waits; ++entry) {
    if (was_answered(*entry))
      continue;
    entry->state = OutputState::playing;
    last_turn_.push_back(std::move(*entry));
  }
  entries_.erase(entries_.begin(), waits);
  return std::span(last_turn_).subspan(before);
}

// Ids rise in the order of releases.
void OutputQueue::forget_what_is_too_much() {
  if (last_turn_.size() <= most_repeated)
    return;
  last_turn_.erase(last_turn_.begin(),
                   last_turn_.end() - std::ptrdiff_t{most_repeated});
  std::erase_if(cut_, [&](const auto& entry) {
    return entry.first < last_turn_.front().id;
  });
}

// Who says a wish twice in one turn hears its answer once.
bool OutputQueue::was_answered(const Output& output) const {
  return output.act == OutputAct::answer && output.turn != 0 &&
         std::any_of(
             last_turn_.begin(), last_turn_.end(), [&](const Output& other) {
               return other.turn == output.turn && other.text == output.text;
             });
}

bool OutputQueue::empty() const {
  return entries_.empty();
}

// "The lift is over there, behind the …" (the visitor coughs) is repeated as
// far as it was heard.
std::vector<std::string> OutputQueue::last_turn() const {
  std::vector<std::string> texts;
  const auto count = std::min(last_turn_.size(), most_repeated);
  for (const auto& output :
       std::span(last_turn_).subspan(last_turn_.size() - count)) {
    const auto cut =
        std::find_if(cut_.begin(), cut_.end(), [&](const auto& entry) {
          return entry.first == output.id;
        });
    const auto& heard = cut == cut_.end() ? output.text : cut->second;
    if (!heard.empty())
      texts.push_back(heard);
  }
  return texts;
}

const Output* OutputQueue::released(OutputId id) const {
  const auto found = std::find_if(last_turn_.begin(), last_turn_.end(),
                                  [&](const Output& o) { return o.id == id; });
  return found == last_turn_.end() ? nullptr : &*found;
}

std::optional<Output> OutputQueue::cut(OutputId id, std::string heard) {
  const auto* output = released(id);
  if (!output)
    return std::nullopt;
  std::erase_if(cut_, [&](const auto& entry) { return entry.first == id; });
  cut_.emplace_back(id, std::move(heard));
  return *output;
}

void OutputQueue::turn_begins() {
  fresh_turn_ = true;
}

} // namespace parlour::dialogue
