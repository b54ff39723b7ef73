#include "script/dialogue/context/running_script.hpp"

#include <variant>

namespace parlour::dialogue {

namespace {

// Of several transits in one activation the last counts (engine rule 2.3).
void keep_last_transit(StepList& steps) {
  const auto is_transit = is<steps::Transit>;
  auto transits = std::count_if(steps.begin(), steps.end(), is_transit);
  if (transits > 1)
    steps.take_if(
        [&](const Step& step) { return is_transit(step) && --transits > 0; });
}

} // namespace

WaitId RunningScript::begin_wait(WaitFor what) {
  wait_ = {context_.next_id(), what};
  return wait_.id;
}

void RunningScript::begins(CodeId body, Origin origin) {
  body_ = body;
  origin_ = origin;
  redirected_.erase(body);
  acted_.erase(body);
}

void RunningScript::goes_on(CodeId body, Origin origin, StepList later) {
  body_ = body;
  origin_ = origin;
  later_ = std::move(later);
}

bool RunningScript::leaves_its_state() const {
  return std::any_of(later_.begin(), later_.end(), [](const Step& step) {
    return is<steps::Transit>(step) || is<steps::Pop>(step);
  });
}

// The turn of an act is held here and let go by who takes the act: between the
// two the pipeline may be done with the message, and the turn must not count as
// over.
StepList RunningScript::take_over() {
  keep_last_transit(later_);
  StepList steps;
  while (!later_.empty() && messenger_.one_more_internal_event()) {
    const auto& step = steps.append(later_.take());
    if (is<steps::TakeAct>(step) || is<steps::NoMatch>(step))
      context_.turns.hold(dialogue::turn_of(step));
  }
  while (!later_.empty()) // what is too much
    drop(later_.take()->step);
  return steps;
}

// Nobody is to take it any more; who pushed does not wait for ever.
void RunningScript::drop(const Step& step) {
  if (const auto* push = std::get_if<steps::Push>(&step))
    context_.lane.queue(outcome_step(
        push->wait, fail(ErrorKind::cancelled, "the state was not entered")));
}

} // namespace parlour::dialogue
