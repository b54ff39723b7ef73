#include "script/dialogue/engine/pipeline.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/core.hpp"

namespace parlour::dialogue {

using namespace std::string_view_literals;

namespace {

constexpr std::string_view any = "*";

inline bool fits(const std::string& wanted, const std::string& name) {
  return wanted == name || wanted == any;
}

} // namespace

Pipeline::Pipeline(Core& core) : core_(core) {}

void Pipeline::take(Input&& input) {
  if (core_.answers.take_meaning(input))
    return;
  if (auto* before = waits_before(input)) {
    hold(*before, std::move(input));
    return;
  }
  Item item;
  item.is_said = input.begins_turn;
  item.turn = input.turn;
  item.raised = input.raised;
  item.reactions = std::exchange(spare_, {});
  visit_matches(input.message->source, input.message->command,
                [&](const Match& match) {
                  item.reactions.push_back(match);
                  return true;
                });
  if (asks_again(item) && core_.answers.take(input))
    return;
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
  using enum Runner::WaitFor;
  return item.message->source == input.message->source &&
         item.message->command == input.message->command &&
         (item.what == answer || (item.what == time && input.turn == 0));
}

bool Pipeline::asks_again(const Item& item) const {
  return std::any_of(waiting_.begin(), waiting_.end(), [&](const auto& other) {
    return other->what == Runner::WaitFor::user &&
           std::any_of(item.reactions.begin(), item.reactions.end(),
                       [&](const Match& match) {
                         return match.reaction == other->running().reaction &&
                                match.visit == other->running().visit;
                       });
  });
}

void Pipeline::hold(Item& item, Input input) {
  if (item.behind.size() < most_held) {
    item.behind.push_back(std::move(input));
    return;
  }
  const Error error{ErrorKind::limit,
                    "more than " + std::to_string(most_held) + " messages " +
                        item.message->source + "." + item.message->command +
                        " wait behind a handler that waits; this one is "
                        "dropped",
                    {}};
  // Whoever handles errors is told of the first, unless he is the one.
  if (std::exchange(item.overflows, true) ||
      input.message->source == "Script"sv)
    core_.inspect(InspectionKind::error, std::string(name_of(error.kind)),
                  to_string(error));
  else
    core_.script_failed(error, input.turn);
  core_.drop(input);
}

bool Pipeline::Match::named() const {
  return reaction->source != any && reaction->event != any;
}

template <class Visit>
bool Pipeline::visit_each(const std::vector<script::Reaction>& reactions,
                          VisitId of_state, bool captures,
                          const std::string& source, const std::string& event,
                          Visit& visit) const {
  for (const auto& reaction : reactions)
    if (fits(reaction.event, event) && is_source(reaction.source, source) &&
        !visit(Match{&reaction, of_state, captures}))
      return false;
  return true;
}

template <class Visit>
void Pipeline::visit_matches(const std::string& source,
                             const std::string& event, Visit visit) const {
  if (auto state = core_.states.active(); state != script::no_id) {
    const auto& active = core_.program->states[state];
    const bool captures = active.capture != script::Capture::none;
    if (!visit_each(active.messages, core_.states.visit(), captures, source,
                    event, visit) ||
        active.capture == script::Capture::all)
      return;
  }
  for (const auto& handler : core_.program->handlers)
    if ((unregistered_.empty() || !unregistered_.contains(handler.name)) &&
        !visit_each(handler.reactions, 0, false, source, event, visit))
      return;
}

bool Pipeline::is_source(const std::string& wanted,
                         const std::string& source) const {
  return wanted == source || wanted == any ||
         core_.port.is_source(wanted, source);
}

std::vector<Pipeline::Match> Pipeline::matches(const std::string& source,
                                               const std::string& event) const {
  std::vector<Match> found;
  visit_matches(source, event, [&](const Match& match) {
    found.push_back(match);
    return true;
  });
  return found;
}

bool Pipeline::listens(const std::string& source,
                       const std::string& event) const {
  bool found = false;
  visit_matches(source, event, [&](const Match&) {
    found = true;
    return false;
  });
  return found;
}

bool Pipeline::state_listens(const std::string& source,
                             std::string_view event) const {
  const auto state = core_.states.active();
  if (state == script::no_id)
    return false;
  const auto& active = core_.program->states[state];
  bool found = active.capture != script::Capture::none;
  auto visit = [&](const Match&) {
    found = true;
    return false;
  };
  visit_each(active.messages, 0, false, source, std::string(event), visit);
  return found;
}

void Pipeline::go_on(Item& item) {
  while (item.next < item.reactions.size() && !item.consumed) {
    const auto& match = item.reactions[item.next++];
    script::ActivationContext context;
    context.message = item.message;
    context.turn = item.turn;
    context.handles_error = item.message->source == "Script"sv &&
                            item.message->command == "Error"sv;
    item.consumed = match.captures;
    core_.effects.reached(match.reaction->position);
    running_ = &item;
    const auto wait = core_.runner.start(
        match.reaction->body, {}, std::move(context), {.visit = match.visit});
    started(item, wait);
    if (item.waiting != 0) {
      keep(std::move(item));
      return;
    }
  }
  finish(item);
}

// It ended, or waits.
void Pipeline::started(Item& item, WaitId wait) {
  running_ = nullptr;
  item.waiting = wait;
  item.what = core_.runner.waits_for(wait);
  auto steps = core_.runner.hand_over();
  if (wait != 0)
    steps.prepend(core_.machine.dropped_by(wait));
  core_.take_from_pipeline(std::move(steps), item.turn);
}

// Only what a component works for holds back the questions to the user.
void Pipeline::keep(Item&& item) {
  if (item.what != Runner::WaitFor::answer) {
    if (std::exchange(item.holds_turn, false))
      core_.turns.let_go(item.turn);
    let_go_of_held(item);
  }
  waiting_.push_back(std::make_unique<Item>(std::move(item)));
}

// Those that need not wait go first, before what came after them.
void Pipeline::let_go_of_held(Item& item) {
  auto& held = item.behind;
  const auto free =
      std::stable_partition(held.begin(), held.end(), [&](const Input& input) {
        return item.waiting != 0 && holds(item, input);
      });
  for (auto input = held.end(); input != free;)
    core_.inbox.push_front(std::move(*--input));
  held.erase(free, held.end());
}

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
  running_ = &item;
  started(item, core_.runner.resume(wait, std::move(outcome)));
  if (item.waiting != 0)
    keep(std::move(item));
  else
    go_on(item);
  return true;
}

void Pipeline::finish(Item& item) {
  const bool taken = item.next > 0;
  if (core_.mouth.waits_for_words())
    core_.mouth.handled(*item.message, was_worded(item));
  core_.effects.sockets.handled(*item.message);
  const bool nothing = means_nothing(item);
  if (!taken && !nothing)
    core_.effects.unhandled(*item.message, item.turn, item.raised);
  if (nothing || (!taken && item.is_said))
    not_understood(item, taken);
  if (item.holds_turn)
    core_.turns.let_go(item.turn);
  let_go_of_held(item);
  item.reactions.clear();
  spare_ = std::move(item.reactions);
}

// Who listens to everything has not meant to say it in other words.
bool Pipeline::was_worded(const Item& item) {
  return std::any_of(item.reactions.begin(),
                     item.reactions.begin() +
                         static_cast<std::ptrdiff_t>(item.next),
                     [](const Match& match) { return match.named(); });
}

// The understanding gave up, or broke. Words that nobody takes are not
// understood either.
bool Pipeline::means_nothing(const Item& item) const {
  const auto& event = *item.message;
  const bool broke = event.command == "Failed"sv && item.turn != 0;
  return (broke || event.command == "NoResult"sv) &&
         core_.port.is_source("NLU", event.source);
}

// The question that was asked comes again; a handler
// that took the event has made the apology (engine rule 5).
void Pipeline::not_understood(const Item& item, bool taken) {
  Step step;
  step.kind = StepKind::no_match;
  step.turn = item.turn;
  step.mark = taken ? 1 : 0;
  core_.turns.hold(step.turn);
  core_.lane.queue({std::move(step)});
}

bool Pipeline::consume() {
  if (running_)
    running_->consumed = true;
  return running_ != nullptr;
}

void Pipeline::register_handler(const std::string& name, bool registered) {
  if (registered)
    unregistered_.erase(name);
  else
    unregistered_.insert(name);
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
