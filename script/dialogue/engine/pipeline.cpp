#include "script/dialogue/engine/pipeline.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace parlour::dialogue {

using namespace std::string_view_literals;

namespace {

// Cancel, cancel everything, start over.
bool is_in_front(const Step& step) {
  const auto* taken = std::get_if<steps::TakeAct>(&step);
  return taken && passes_waits(*taken->act);
}

} // namespace

// The order is: a meaning that Answers has asked for, then a handler that holds
// such messages, then words that may answer a handler which waits for the user,
// then the reactions.
void Pipeline::take(Input&& input) {
  const auto turn = input.turn;
  if (auto acts = answers_.take_meaning(input)) {
    hand_over(std::move(*acts), turn);
    return;
  }
  if (auto* before = waits_before(input)) {
    hold(*before, std::move(input));
    return;
  }
  Item item;
  item.is_said = input.begins_turn || input.is_unclear;
  item.turn = input.turn;
  item.raised = input.raised;
  item.reactions = std::exchange(spare_, {});
  reactions_.find(input.message->source, input.message->command,
                  item.reactions);
  if (asks_again(item))
    if (auto acts = answers_.take(input)) {
      hand_over(std::move(*acts), turn);
      return;
    }
  item.message = std::move(input.message);
  go_on(item);
}

Pipeline::Item* Pipeline::waits_before(const Input& input) const {
  for (const auto& item : waiting_)
    if (holds(*item, input))
      return item.get();
  return nullptr;
}

bool Pipeline::holds(const Item& item, const Input& input) {
  using enum WaitFor;
  return item.message->source == input.message->source &&
         item.message->command == input.message->command &&
         (item.what == answer || (item.what == time && input.turn == 0));
}

// The same reaction of another visit of its state does not count: what it asked
// ended with that visit.
bool Pipeline::asks_again(const Item& item) const {
  return std::any_of(waiting_.begin(), waiting_.end(), [&](const auto& other) {
    return other->what == WaitFor::user &&
           std::any_of(item.reactions.begin(), item.reactions.end(),
                       [&](const Reactions::Match& match) {
                         return match.reaction == other->running().reaction &&
                                match.visit == other->running().visit;
                       });
  });
}

// The first that is dropped is raised as Script.Error, the others are only
// shown: an error for each would be as many events again.
void Pipeline::hold(Item& item, Input input) {
  if (item.behind.size() < max_held) {
    item.behind.push_back(std::move(input));
    return;
  }
  const Error error{ErrorKind::limit,
                    "more than " + std::to_string(max_held) + " messages " +
                        item.message->source + "." + item.message->command +
                        " wait behind a handler that waits; this one is "
                        "dropped",
                    {}};
  // Whoever handles errors is told of the first, unless he is the one.
  if (std::exchange(item.overflows, true) ||
      input.message->source == "Script"sv)
    context_.inspect(InspectionKind::error, std::string(name_of(error.kind)),
                     to_string(error));
  else
    messenger_.script_failed(error, input.turn);
  message_end_.dropped(input);
}

// A reaction of a state with capture takes the message whatever it does, so
// `consumed` is set before it runs. When one waits, the item moves into
// `waiting_`, and what comes behind it runs in resume().
void Pipeline::go_on(Item& item) {
  while (item.next < item.reactions.size() && !item.consumed) {
    const auto& match = item.reactions[item.next++];
    script::ActivationContext context;
    context.message = item.message;
    context.turn = item.turn;
    context.handles_error = item.message->source == "Script"sv &&
                            item.message->command == "Error"sv;
    item.consumed = match.captures;
    context_.reached(match.reaction->position);
    handled_.begins();
    const auto ran = runner_.start(match.reaction->body, {}, std::move(context),
                                   {.visit = match.visit});
    started(item, ran.wait);
    if (item.waiting != 0) {
      keep(std::move(item));
      return;
    }
  }
  finish(item);
}

// It ended, or waits; what it asked before is given up then: nobody could tell
// which of two such questions an answer is for.
void Pipeline::started(Item& item, WaitId wait) {
  if (handled_.ends())
    item.consumed = true;
  item.waiting = wait;
  item.what = runner_.waits_for(wait);
  auto wanted = running_.hand_over();
  if (wait != 0)
    wanted.prepend(machine_.dropped_by(wait));
  hand_over(std::move(wanted), item.turn);
}

// Who wants out, or to start over, does not wait for what waits there (engine
// rule 2.5). Only where the lane is held: else the act is taken soon, and its
// own step (Cancel, Restart) ends what it is about.
void Pipeline::hand_over(StepList steps, TurnId turn) {
  if (steps.empty())
    return;
  if (std::any_of(steps.begin(), steps.end(), is_in_front) &&
      context_.lane.held()) {
    context_.lane.now(waits_.cancel(waits(), topics_.confirms_but_of({})));
    machine_.clear_pushed();
  }
  steps.add(steps::Conclude{turn});
  context_.lane.queue(std::move(steps));
}

// Only what a component works for holds back the questions to the user. What is
// behind an item that does not wait for an answer may go on, too.
void Pipeline::keep(Item&& item) {
  if (item.what != WaitFor::answer) {
    if (std::exchange(item.holds_turn, false))
      context_.turns.let_go(item.turn);
    let_go_of_held(item);
  }
  waiting_.push_back(std::make_unique<Item>(std::move(item)));
}

// Those that need not wait go first, before what came after them: they are put
// back in front of the inbox, the last one first.
void Pipeline::let_go_of_held(Item& item) {
  auto& held = item.behind;
  const auto free =
      std::stable_partition(held.begin(), held.end(), [&](const Input& input) {
        return item.waiting != 0 && holds(item, input);
      });
  for (auto input = held.end(); input != free;)
    inbox_.put_back(std::move(*--input));
  held.erase(free, held.end());
}

// The item is taken out before the script runs, which may wait again or end
// other waits. A script that was cancelled sees its error, but the message goes
// to no further handler (language rule 12.16).
bool Pipeline::resume(WaitId wait, Expected<Value> outcome) {
  auto found =
      std::find_if(waiting_.begin(), waiting_.end(),
                   [&](const auto& item) { return item->waiting == wait; });
  if (found == waiting_.end())
    return false;
  auto item = std::move(**found);
  waiting_.erase(found);
  // Who wants out has no use for what would come of it.
  if (!outcome && outcome.error().kind == ErrorKind::cancelled)
    item.consumed = true;
  handled_.begins();
  const auto ran = runner_.resume(wait, std::move(outcome));
  topics_.wait_is_over(wait);
  started(item, ran.wait);
  if (item.waiting != 0)
    keep(std::move(item));
  else
    go_on(item);
  return true;
}

// The list of reactions is kept for the next message, so that most messages
// cost no allocation for it.
void Pipeline::finish(Item& item) {
  message_end_.handled({.message = *item.message,
                        .turn = item.turn,
                        .raised = item.raised,
                        .is_said = item.is_said,
                        .taken = item.next > 0,
                        .worded = was_worded(item)});
  if (item.holds_turn)
    context_.turns.let_go(item.turn);
  let_go_of_held(item);
  item.reactions.clear();
  spare_ = std::move(item.reactions);
}

// Who listens to everything has not meant to say it in other words.
bool Pipeline::was_worded(const Item& item) {
  return std::any_of(
      item.reactions.begin(),
      item.reactions.begin() + static_cast<std::ptrdiff_t>(item.next),
      [](const Reactions::Match& match) { return match.named(); });
}

bool Pipeline::waits(WaitId wait) const {
  return std::any_of(waiting_.begin(), waiting_.end(),
                     [&](const auto& item) { return item->waiting == wait; });
}

std::vector<WaitId> Pipeline::waits() const {
  std::vector<WaitId> ids;
  for (const auto& item : waiting_)
    ids.push_back(item->waiting);
  return ids;
}

} // namespace parlour::dialogue
