#include "script/dialogue/pipeline.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "script/dialogue/core.hpp"
#include "script/dialogue/steps.hpp"

namespace parlour::dialogue {

using namespace std::string_view_literals;

namespace {

constexpr std::string_view any = "*";

inline bool fits(const std::string& wanted, const std::string& name) {
  return wanted == name || wanted == any;
}

bool wants_out(const Step& step) {
  return step.kind == StepKind::take_act &&
         (step.act->kind == ActKind::cancel ||
          step.act->kind == ActKind::abandon ||
          step.act->kind == ActKind::restart);
}

} // namespace

Pipeline::Pipeline(Core& core) : core_(core) {}

void Pipeline::take(Input&& input) {
  if (auto* before =
          waiting_.empty() ? nullptr : waits_before(*input.message)) {
    hold(*before, std::move(input));
    return;
  }
  Item item;
  item.turn = input.turn;
  item.raised = input.raised;
  item.reactions = std::exchange(spare_, {});
  visit_matches(input.message->source, input.message->command,
                [&](const Match& match) {
                  item.reactions.push_back(match);
                  return true;
                });
  item.message = std::move(input.message);
  go_on(item);
}

Pipeline::Item* Pipeline::waits_before(const Message& message) const {
  for (const auto& item : waiting_)
    if (item->message->source == message.source &&
        item->message->command == message.command)
      return item.get();
  return nullptr;
}

void Pipeline::hold(Item& item, Input input) {
  if (item.behind.size() < most_held) {
    item.behind.push_back(std::move(input));
    return;
  }
  core_.inspect(InspectionKind::error, "Limit",
                "more than " + std::to_string(most_held) + " messages " +
                    item.message->source + "." + item.message->command +
                    " wait behind a handler that waits; this one is dropped");
  core_.drop(input);
}

bool Pipeline::Match::named() const {
  return reaction->source != any && reaction->event != any;
}

template <class Visit>
bool Pipeline::visit_each(const std::vector<script::Reaction>& reactions,
                          bool captures, const std::string& source,
                          const std::string& event, Visit& visit) const {
  for (const auto& reaction : reactions)
    if (fits(reaction.event, event) && is_source(reaction.source, source) &&
        !visit(Match{&reaction, captures}))
      return false;
  return true;
}

template <class Visit>
void Pipeline::visit_matches(const std::string& source,
                             const std::string& event, Visit visit) const {
  if (auto state = core_.states.active(); state != script::no_id) {
    const auto& active = core_.program->states[state];
    const bool captures = active.capture != script::Capture::none;
    if (!visit_each(active.messages, captures, source, event, visit) ||
        active.capture == script::Capture::all)
      return;
  }
  for (const auto& handler : core_.program->handlers)
    if ((unregistered_.empty() || !unregistered_.contains(handler.name)) &&
        !visit_each(handler.reactions, false, source, event, visit))
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
    item.waiting =
        core_.runner.start(match.reaction->body, {}, std::move(context));
    running_ = nullptr;
    hand_over(item);
    if (item.waiting != 0) {
      keep(std::move(item));
      return;
    }
  }
  finish(item);
}

void Pipeline::keep(Item&& item) {
  waiting_.push_back(std::make_unique<Item>(std::move(item)));
}

// What the script asked for becomes an item of the dialogue lane, which ends
// with the question that is then due.
void Pipeline::hand_over(const Item& item) {
  auto steps = core_.runner.hand_over();
  if (steps.empty())
    return;
  // Cancel and start over pass every wait (engine rule 2).
  if (std::any_of(steps.begin(), steps.end(), wants_out) && core_.lane.held()) {
    core_.lane.now(core_.cancel_waits());
    core_.machine.clear_pushed();
  }
  steps.add(StepKind::conclude).turn = item.turn;
  core_.lane.queue(std::move(steps));
}

bool Pipeline::resume(WaitId wait, Expected<Value> outcome) {
  auto found =
      std::find_if(waiting_.begin(), waiting_.end(),
                   [&](const auto& item) { return item->waiting == wait; });
  if (found == waiting_.end())
    return false;
  auto item = std::move(**found);
  waiting_.erase(found);
  running_ = &item;
  item.waiting = core_.runner.resume(wait, std::move(outcome));
  running_ = nullptr;
  hand_over(item);
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
  if (means_nothing(item))
    not_understood(item, taken);
  else if (!taken)
    core_.effects.unhandled(*item.message, item.turn, item.raised);
  core_.turns.let_go(item.turn);
  // The held messages go first, before what came after them.
  while (!item.behind.empty()) {
    core_.inbox.push_front(std::move(item.behind.back()));
    item.behind.pop_back();
  }
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

// The understanding gave up, or broke.
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
