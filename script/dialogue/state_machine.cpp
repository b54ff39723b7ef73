#include "script/dialogue/state_machine.hpp"

#include <string_view>
#include <utility>

#include "script/dialogue/core.hpp"
#include "script/dialogue/steps.hpp"

namespace parlour::dialogue {

using namespace std::string_view_literals;

namespace {

std::string name_of(const Core& core, StateId state) {
  return state == script::no_id ? "" : core.program->states[state].name;
}

} // namespace

void StateMachine::transit(Step&& step) {
  const auto left = core_.states.active();
  const bool exits = left != script::no_id &&
                     core_.program->states[left].exit != script::no_code;
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
  core_.lane.at_once(std::move(enter));
  // In between, what stands in <transit>: with the topic, message and turn of
  // the script that it is a part of.
  if (step.code != script::no_code)
    core_.lane.at_once(make_step(StepKind::run_leaving, std::move(step)));
  core_.lane.at_once(std::move(leave));
}

void StateMachine::leave(const Step& step) {
  if (step.state == script::no_id)
    return;
  if (auto code = core_.program->states[step.state].exit;
      code != script::no_code)
    core_.lane.at_once(make_step(StepKind::run_leaving, body_step(code, 0)));
}

void StateMachine::enter(const Step& step) {
  if (core_.port.inspected())
    core_.inspect(InspectionKind::transition,
                  core_.program->states[step.state].name,
                  "from '" + name_of(core_, core_.states.active()) + "'");
  core_.states.enter(step.state);
  const auto& state = core_.program->states[step.state];
  if (state.entrance != script::no_code)
    core_.lane.at_once(body_step(state.entrance, 0));
}

void StateMachine::push(const Step& step) {
  core_.states.push(script::no_id);
  pushes_.push_back({step.wait, step.topic});
  enter(step);
}

// First its Exit, in which it still is the active one; then back.
void StateMachine::pop(const Step& step) {
  if (pushes_.empty())
    return;
  if (step.mark == 0) {
    core_.lane.now(way_out(core_.states.active()));
    return;
  }
  core_.states.pop();
  const auto [wait, topic] = pushes_.back();
  pushes_.pop_back();
  core_.lane.now(core_.topics.back_to(topic));
  if (!core_.lane.wake(wait, outcome_step(wait, Value()))) // a handler's
    core_.lane.at_once(outcome_step(wait, Value()));
}

bool StateMachine::agent_changed(const Message& event) {
  const auto state = core_.states.active();
  if (state == script::no_id || event.source != "System"sv ||
      event.params.empty())
    return false;
  const auto& definition = core_.program->states[state];
  const bool came = event.command == "AgentOnline"sv;
  if (!came && event.command != "AgentOffline"sv)
    return false;
  const auto agent = event.params[0].text();
  auto shared = std::make_shared<const Message>(event);
  bool any = false;
  for (const auto& reaction : came ? definition.online : definition.offline)
    if (reaction.source == "*" || reaction.source == agent) {
      react(reaction, shared);
      any = true;
    }
  return any;
}

void StateMachine::react(const script::Reaction& reaction,
                         std::shared_ptr<const Message> event) {
  auto step = body_step(reaction.body, 0);
  step.matter().message = std::move(event);
  core_.effects.reached(reaction.position);
  core_.lane.queue({std::move(step), conclude_step(0)});
}

void StateMachine::greet_agents() {
  const auto state = core_.states.active();
  if (state == script::no_id)
    return;
  for (const auto& reaction : core_.program->states[state].online) {
    if (reaction.source == "*" || !core_.port.reachable(reaction.source))
      continue;
    Message event;
    event.source = "System";
    event.command = "AgentOnline";
    event.params = {reaction.source};
    event.time = core_.now;
    event.session = core_.options.session;
    react(reaction, std::make_shared<const Message>(std::move(event)));
  }
}

StepList StateMachine::way_out(StateId state) const {
  Step leave;
  leave.kind = StepKind::leave;
  leave.state = state;
  Step back;
  back.kind = StepKind::pop;
  back.mark = 1;
  return {std::move(leave), std::move(back)};
}

void StateMachine::clear_pushed() {
  pushes_.clear();
  while (core_.states.pop()) {
  }
}

void StateMachine::clear() {
  clear_pushed();
  core_.states.enter(script::no_id);
}

StepList StateMachine::exits() const {
  StepList steps;
  const auto& levels = core_.states.levels();
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
    steps.append(way_out(*level));
  return steps;
}

} // namespace parlour::dialogue
