#include "script/dialogue/runner.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/core.hpp"

namespace parlour::dialogue {

namespace {

// Of several transits in one activation the last counts (engine rule 2).
void keep_last_transit(StepList& steps) {
  auto is_transit = [](const Step& step) {
    return step.kind == StepKind::transit;
  };
  auto transits = std::count_if(steps.begin(), steps.end(), is_transit);
  if (transits > 1)
    steps.take_if(
        [&](const Step& step) { return is_transit(step) && --transits > 0; });
}

} // namespace

Runner::Runner(Core& core) : core_(core) {}

WaitId Runner::start(CodeId code, const std::vector<Value>& arguments,
                     script::ActivationContext context) {
  auto stopped = core_.interpreter.run_body(code, arguments, std::move(context),
                                            core_.effects);
  return stopped ? dispose(std::move(stopped->activation), stopped->result) : 0;
}

WaitId Runner::resume(WaitId wait, Expected<Value> outcome) {
  auto found = waiting_.find(wait);
  if (found == waiting_.end())
    return 0;
  auto waiting = std::move(found->second);
  waiting_.erase(found);
  later_ = std::move(waiting.later);
  core_.timers.cancel_wait(wait);
  // A yielded activation goes on by itself, unless it is being ended.
  auto result =
      waiting.yielded && outcome
          ? core_.interpreter.run(*waiting.activation, core_.effects)
          : core_.interpreter.resume(*waiting.activation, std::move(outcome),
                                     core_.effects);
  return dispose(std::move(waiting.activation), result);
}

bool Runner::for_user(WaitId wait) const {
  auto found = waiting_.find(wait);
  return found != waiting_.end() && found->second.for_user;
}

WaitId Runner::take_slice() {
  if (slices_.empty())
    return 0;
  return slices_.take();
}

Expected<Value> Runner::evaluate(CodeId code,
                                 const std::vector<Value>& arguments,
                                 TopicId topic) {
  script::ActivationContext context;
  context.topic = topic;
  return core_.interpreter.evaluate(code, arguments, std::move(context),
                                    core_.effects);
}

WaitId Runner::dispose(std::unique_ptr<script::Activation> activation,
                       const script::RunResult& result) {
  using enum script::RunStatus;
  WaitId id = 0;
  if (result.status == failed)
    report(activation->context(), result);
  if (result.status == waiting) {
    id = expected_.id;
    waiting_[id] = {std::move(activation), expected_.for_user, false, {}};
  }
  if (result.status == yielded) {
    id = core_.next_id();
    waiting_[id] = {std::move(activation), false, true,
                    std::exchange(later_, {})};
    slices_.push_back(id);
  }
  expected_ = {};
  return id;
}

void Runner::report(const script::ActivationContext& context,
                    const script::RunResult& result) {
  auto detail = to_string(result.error);
  for (const auto& line : result.stack)
    detail += "\n  in " + line;
  // To be cancelled is no fault of the script.
  const bool cancelled = result.error.kind == ErrorKind::cancelled;
  core_.inspect(cancelled ? InspectionKind::cancelled : InspectionKind::error,
                std::string(name_of(result.error.kind)), detail);
  if (!cancelled && !context.handles_error)
    core_.raise_error(result.error, context.turn);
}

StepList Runner::hand_over() {
  if (later_.empty())
    return {};
  keep_last_transit(later_);
  StepList steps;
  while (!later_.empty() && core_.one_more_internal_event()) {
    const auto& step = steps.append(later_.take());
    if (step.kind == StepKind::take_act || step.kind == StepKind::no_match)
      core_.turns.hold(step.turn);
  }
  later_.clear(); // what is too much
  return steps;
}

} // namespace parlour::dialogue
