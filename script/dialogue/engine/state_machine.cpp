#include "script/dialogue/engine/state_machine.hpp"

#include <algorithm>
#include <concepts>
#include <functional>
#include <string_view>
#include <utility>

namespace parlour::dialogue {

using namespace std::string_view_literals;

namespace {

constexpr std::size_t max_pushed = 100;

tl::unexpected<Error> was_given_up() {
  return fail(ErrorKind::cancelled, "it was asked anew");
}

std::string name_of(const DialogueContext& context, StateId state) {
  return state == script::no_id ? "" : context.program->states[state].name;
}

} // namespace

void StateMachine::take(steps::Transit&& step) {
  if (comes_later(step))
    return;
  const auto left = context_.states.active();
  const bool exits = left != script::no_id &&
                     context_.program->states[left].exit != script::no_code;
  if (!exits && step.body.code == script::no_code) { // nothing in between
    enter(step.state);
    return;
  }
  const steps::Enter enter{step.state};
  passage_ = enter;
  context_.lane.at_once(enter);
  // In between, what stands in <transit>: with the topic, message and turn of
  // the script that it is a part of.
  if (step.body.code != script::no_code)
    context_.lane.at_once(steps::RunLeaving{std::move(step.body)});
  context_.lane.at_once(steps::Leave{left});
}

template <class Kind>
bool StateMachine::comes_later(Kind& step) {
  if (!passage_)
    return false;
  if constexpr (std::same_as<Kind, steps::Transit>) // the last one counts
    std::erase_if(later_, is<steps::Transit>);
  later_.push_back(std::move(step));
  return true;
}

void StateMachine::end_passage() {
  passage_.reset();
  for (auto& step : std::exchange(later_, {})) {
    const auto turn = turn_of(step);
    context_.lane.queue({std::move(step), steps::Conclude{turn}});
  }
}

void StateMachine::take(const steps::Leave& step) {
  if (step.state == script::no_id)
    return;
  if (auto code = context_.program->states[step.state].exit;
      code != script::no_code)
    context_.lane.at_once(steps::RunLeaving{{.code = code}});
}

void StateMachine::take(const steps::Enter& step) {
  enter(step.state);
}

void StateMachine::enter(StateId state) {
  const auto& entered = context_.program->states[state];
  if (context_.port.inspected())
    context_.inspect(InspectionKind::transition, entered.name,
                     "from '" + name_of(context_, context_.states.active()) +
                         "'");
  context_.states.enter(state);
  end_passage();
  if (entered.entrance != script::no_code)
    context_.lane.at_once(
        steps::Run{{.code = entered.entrance,
                    .origin = {.visit = context_.states.visit()}}});
  forget_what_was_left();
}

void StateMachine::take(steps::Push&& step) {
  if (comes_later(step))
    return;
  if (context_.states.levels().size() > max_pushed) {
    end_wait(step.wait,
             fail(ErrorKind::limit, "more than " + std::to_string(max_pushed) +
                                        " states pushed from one another"));
    return;
  }
  context_.states.push({step.wait, step.topic});
  enter(step.state);
}

// First its Exit, in which it still is the active one; then back.
void StateMachine::take(steps::Pop&& step) {
  if (!comes_later(step) && context_.states.pushed())
    begin_way_out(false);
}

void StateMachine::take(const steps::ComeBack& step) {
  end_passage();
  if (!context_.states.pushed())
    return;
  const auto [wait, topic] = context_.states.pop();
  if (step.given_up) {
    end_wait(wait, was_given_up());
  } else {
    context_.lane.now(topics_.back_to(topic));
    end_wait(wait, Value());
  }
  forget_what_was_left();
}

void StateMachine::begin_way_out(bool given_up) {
  const steps::ComeBack back{given_up};
  passage_ = back;
  context_.lane.now({steps::Leave{context_.states.active()}, back});
}

// Of those that were pushed one after the other, the innermost first.
void StateMachine::take(steps::GiveUp&& step) {
  if (comes_later(step))
    return;
  if (!context_.states.was_pushed_for(step.wait)) {
    end_wait(step.wait, was_given_up());
    return;
  }
  if (context_.states.levels().back().by.wait != step.wait)
    context_.lane.at_once(step);
  begin_way_out(true);
}

StepList StateMachine::dropped_by(WaitId wait) const {
  StepList dropped;
  for (const auto earlier : runner_.asked_before(wait))
    dropped.add(steps::GiveUp{earlier});
  return dropped;
}

void StateMachine::end_wait(WaitId wait, Expected<Value> outcome) {
  waits_.forget_request(wait);
  topics_.forget_confirm(wait);
  context_.lane.at_once(outcome_step(wait, std::move(outcome)));
}

void StateMachine::forget_what_was_left() {
  timers_.end_with(
      [&](VisitId visit) { return !context_.states.lasts(visit); });
  for (const auto wait : runner_.take_those_of_left_states())
    end_wait(wait, fail(ErrorKind::cancelled, "its state was left"));
}

bool StateMachine::agent_changed(const Message& event) {
  const auto* state = context_.active_state();
  if (!state || event.source != "System"sv || event.params.empty())
    return false;
  const bool came = event.command == "AgentOnline"sv;
  if (!came && event.command != "AgentOffline"sv)
    return false;
  const auto agent = event.params[0].text();
  auto shared = std::make_shared<const Message>(event);
  bool any = false;
  for (const auto& reaction : came ? state->online : state->offline)
    if (reaction.source == "*" ||
        context_.port.is_source(reaction.source, agent)) {
      react(reaction, shared);
      any = true;
    }
  return any;
}

void StateMachine::react(const script::Reaction& reaction,
                         std::shared_ptr<const Message> event) {
  context_.reached(reaction.position);
  context_.lane.queue({steps::Run{{.code = reaction.body,
                                   .origin = {.visit = context_.states.visit()},
                                   .input = input_of(std::move(event))}},
                       steps::Conclude{}});
}

void StateMachine::take(const steps::GreetAgents&) {
  const auto* state = context_.active_state();
  if (!state)
    return;
  for (const auto& reaction : state->online) {
    if (reaction.source == "*" || !context_.port.reachable(reaction.source))
      continue;
    Message event;
    event.source = "System";
    event.command = "AgentOnline";
    event.params = {reaction.source};
    event.time = context_.now;
    event.session = context_.options.session;
    react(reaction, std::make_shared<const Message>(std::move(event)));
  }
}

// A state whose Exit has run is left all the same; those who pushed were
// cancelled.
void StateMachine::clear_pushed() {
  std::erase_if(later_, std::not_fn(is<steps::Transit>));
  if (passage_ && !context_.states.pushed())
    context_.lane.queue(*passage_);
  else
    end_passage();
  while (context_.states.pushed())
    context_.states.pop();
  forget_what_was_left();
}

void StateMachine::clear() {
  passage_.reset();
  later_.clear();
  clear_pushed();
  context_.states.enter(script::no_id);
  forget_what_was_left();
}

// One that is being left has had its Exit.
StepList StateMachine::exits() const {
  StepList all;
  const auto& levels = context_.states.levels();
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    if (!passage_ || level != levels.rbegin())
      all.add(steps::Leave{level->state});
    all.add(steps::ComeBack{});
  }
  return all;
}

} // namespace parlour::dialogue
