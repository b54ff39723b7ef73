#include "script/dialogue/engine/state_machine.hpp"

#include <algorithm>
#include <concepts>
#include <functional>
#include <string_view>
#include <utility>

namespace parlour::dialogue {

using namespace std::string_view_literals;

namespace {

// Levels above the bottom one (engine rule 4.3). A script that pushes from each
// Entrance runs into it; conversations need two or three.
constexpr std::size_t max_pushed = 100;

tl::unexpected<Error> was_given_up() {
  return fail(ErrorKind::cancelled, "it was asked anew");
}

std::string name_of(const DialogueContext& context, StateId state) {
  return state == script::no_id ? "" : context.program->states[state].name;
}

} // namespace

// The steps are put in front of the lane in reverse order. Where neither an
// Exit nor children of <transit> have to run, the new state is entered at once,
// and nothing can come in between.
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

// The steps that had to wait become items at the end of the lane, each with a
// conclusion of its own.
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

// The stack changes before the Entrance is queued, as it runs for the new
// visit. What the scripts of the state before wait for is ended last: these
// steps are then in front of the Entrance.
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

// The activation that pushed has waited since its <push>, so a push that is
// refused ends that wait with an error.
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

// The state below becomes the active one without its Entrance. The topic whose
// script pushed becomes the current one again before that script goes on.
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

// Of those that were pushed one after the other, the innermost first: the step
// is put back until its own level is the uppermost.
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

// See engine rule 2.4: who asks again has given up what he asked before.
StepList StateMachine::dropped_by(WaitId wait) const {
  StepList dropped;
  for (const auto earlier : runner_.asked_before(wait))
    dropped.add(steps::GiveUp{earlier});
  return dropped;
}

// The wait may be a <push>, a <confirm> or a <request> that waits for time: all
// are forgotten alike by those that know them.
void StateMachine::end_wait(WaitId wait, Expected<Value> outcome) {
  waits_.forget_request(wait);
  topics_.forget_confirm(wait);
  context_.lane.at_once(outcome_step(wait, std::move(outcome)));
}

// Timers and waits belong to a visit, so the visit's end is all that has to be
// looked at: a state below a pushed one still lasts (engine rule 4.7).
void StateMachine::forget_what_was_left() {
  timers_.end_with(
      [&](VisitId visit) { return !context_.states.lasts(visit); });
  for (const auto wait : runner_.take_those_of_left_states())
    end_wait(wait, fail(ErrorKind::cancelled, "its state was left"));
}

// Reactions to all agents ("*") and to this one run in the order of the file.
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

// At the beginning the events are made here, as the agents came before the
// session did. A reaction to any agent ("*") does not run then: the port is
// asked for names and roles only.
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
// cancelled. So a transit on the bottom level goes on to its Enter, and later
// transits still count; pushes and pops make no sense any more.
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

// One that is being left has had its Exit. After each Exit the level below
// becomes the active one (ComeBack, which does nothing at the bottom), as its
// own Exit runs in its own state.
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
