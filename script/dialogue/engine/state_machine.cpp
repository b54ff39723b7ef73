#include "script/dialogue/engine/state_machine.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"

namespace parlour::dialogue {

using namespace std::string_view_literals;

namespace {

// How far a <pop> is.
enum PopMark : std::uint64_t {
  wanted,   // by a script
  left,     // its Exit has run
  given_up, // so it has, and who pushed gets an error
};

constexpr std::size_t most_pushed = 100;

tl::unexpected<Error> was_given_up() {
  return fail(ErrorKind::cancelled, "it was asked anew");
}

std::string name_of(const DialogueContext& context, StateId state) {
  return state == script::no_id ? "" : context.program->states[state].name;
}

} // namespace

void StateMachine::transit(Step&& step) {
  if (comes_later(step))
    return;
  const auto left = context_.states.active();
  const bool exits = left != script::no_id &&
                     context_.program->states[left].exit != script::no_code;
  if (!exits && step.code == script::no_code) { // nothing to run in between
    enter(step);
    return;
  }
  Step leave;
  leave.kind = StepKind::leave;
  leave.state = left;
  Step enter;
  enter.kind = StepKind::enter;
  enter.state = step.state;
  passage_ = enter;
  context_.lane.at_once(std::move(enter));
  // In between, what stands in <transit>: with the topic, message and turn of
  // the script that it is a part of.
  if (step.code != script::no_code)
    context_.lane.at_once(make_step(StepKind::run_leaving, std::move(step)));
  context_.lane.at_once(std::move(leave));
}

bool StateMachine::comes_later(Step& step) {
  if (!passage_)
    return false;
  if (step.kind == StepKind::transit) // the last one counts
    std::erase_if(later_, [](const Step& other) {
      return other.kind == StepKind::transit;
    });
  later_.push_back(std::move(step));
  return true;
}

void StateMachine::end_passage() {
  passage_.reset();
  for (auto& step : std::exchange(later_, {})) {
    const auto turn = step.turn;
    context_.lane.queue({std::move(step), conclude_step(turn)});
  }
}

void StateMachine::leave(const Step& step) {
  if (step.state == script::no_id)
    return;
  if (auto code = context_.program->states[step.state].exit;
      code != script::no_code)
    context_.lane.at_once(make_step(StepKind::run_leaving, body_step(code, 0)));
}

void StateMachine::enter(const Step& step) {
  if (context_.port.inspected())
    context_.inspect(
        InspectionKind::transition, context_.program->states[step.state].name,
        "from '" + name_of(context_, context_.states.active()) + "'");
  context_.states.enter(step.state);
  end_passage();
  const auto& state = context_.program->states[step.state];
  if (state.entrance != script::no_code) {
    auto entrance = body_step(state.entrance, 0);
    entrance.origin.visit = context_.states.visit();
    context_.lane.at_once(std::move(entrance));
  }
  forget_what_was_left();
}

void StateMachine::push(Step&& step) {
  if (comes_later(step))
    return;
  if (pushes_.size() == most_pushed) {
    end_wait(step.wait,
             fail(ErrorKind::limit, "more than " + std::to_string(most_pushed) +
                                        " states pushed from one another"));
    return;
  }
  context_.states.push(script::no_id);
  pushes_.push_back({step.wait, step.topic});
  enter(step);
}

// First its Exit, in which it still is the active one; then back.
void StateMachine::pop(Step&& step) {
  if (step.mark == wanted) {
    if (!comes_later(step) && !pushes_.empty())
      begin_way_out(left);
    return;
  }
  end_passage();
  if (pushes_.empty())
    return;
  context_.states.pop();
  const auto [wait, topic] = pushes_.back();
  pushes_.pop_back();
  if (step.mark == given_up) {
    end_wait(wait, was_given_up());
  } else {
    context_.lane.now(topics_.back_to(topic));
    end_wait(wait, Value());
  }
  forget_what_was_left();
}

void StateMachine::begin_way_out(std::uint64_t mark) {
  auto steps = way_out(context_.states.active(), mark);
  passage_ = steps.back();
  context_.lane.now(std::move(steps));
}

// Of those that were pushed one after the other, the innermost first.
void StateMachine::give_up(Step&& step) {
  if (comes_later(step))
    return;
  const bool pushed =
      std::any_of(pushes_.begin(), pushes_.end(),
                  [&](const Push& push) { return push.wait == step.wait; });
  if (!pushed) {
    end_wait(step.wait, was_given_up());
    return;
  }
  if (pushes_.back().wait != step.wait)
    context_.lane.at_once(std::move(step));
  begin_way_out(given_up);
}

StepList StateMachine::dropped_by(WaitId wait) const {
  StepList steps;
  for (const auto earlier : runner_.asked_before(wait))
    steps.add(StepKind::give_up).wait = earlier;
  return steps;
}

void StateMachine::end_wait(WaitId wait, Expected<Value> outcome) {
  waits_.forget_request(wait);
  topics_.forget_confirm(wait);
  context_.lane.at_once(outcome_step(wait, std::move(outcome)));
}

void StateMachine::forget_what_was_left() {
  context_.timers.end_with(
      [&](VisitId visit) { return !context_.states.lasts(visit); });
  for (const auto wait : runner_.take_those_of_left_states())
    end_wait(wait, fail(ErrorKind::cancelled, "its state was left"));
}

bool StateMachine::was_pushed_by(TopicId topic) const {
  return std::any_of(pushes_.begin(), pushes_.end(),
                     [&](const Push& push) { return push.topic == topic; });
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
    if (reaction.source == "*" || reaction.source == agent) {
      react(reaction, shared);
      any = true;
    }
  return any;
}

void StateMachine::react(const script::Reaction& reaction,
                         std::shared_ptr<const Message> event) {
  auto step = body_step(reaction.body, 0);
  step.origin.visit = context_.states.visit();
  step.matter().message = std::move(event);
  context_.reached(reaction.position);
  context_.lane.queue({std::move(step), conclude_step(0)});
}

void StateMachine::greet_agents() {
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

StepList StateMachine::way_out(StateId state, std::uint64_t mark) const {
  Step leave;
  leave.kind = StepKind::leave;
  leave.state = state;
  Step back;
  back.kind = StepKind::pop;
  back.mark = mark;
  return {std::move(leave), std::move(back)};
}

// A state whose Exit has run is left all the same; those who pushed were
// cancelled.
void StateMachine::clear_pushed() {
  std::erase_if(
      later_, [](const Step& step) { return step.kind != StepKind::transit; });
  if (passage_ && pushes_.empty())
    context_.lane.queue({*passage_});
  else
    end_passage();
  pushes_.clear();
  while (context_.states.pop()) {
  }
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
  StepList steps;
  const auto& levels = context_.states.levels();
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    auto way = way_out(level->state, left);
    if (passage_ && level == levels.rbegin())
      way.take();
    steps.append(std::move(way));
  }
  return steps;
}

} // namespace parlour::dialogue
