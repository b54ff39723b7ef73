#include "script/dialogue/context/activation_runner.hpp"

#include <algorithm>
#include <utility>

namespace parlour::dialogue {

namespace {

// Of several transits in one activation the last counts (engine rule 2).
void keep_last_transit(StepList& steps) {
  const auto is_transit = is<steps::Transit>;
  auto transits = std::count_if(steps.begin(), steps.end(), is_transit);
  if (transits > 1)
    steps.take_if(
        [&](const Step& step) { return is_transit(step) && --transits > 0; });
}

} // namespace

ActivationRunner::Ran
ActivationRunner::start(CodeId code, const std::vector<Value>& arguments,
                        script::ActivationContext context, Origin origin) {
  code_ = code;
  origin_ = origin;
  redirected_.erase(code);
  acted_.erase(code);
  auto stopped =
      interpreter_.run_body(code, arguments, std::move(context), host_);
  return stopped ? dispose(std::move(stopped->activation), stopped->result)
                 : Ran();
}

ActivationRunner::Ran ActivationRunner::resume(WaitId wait,
                                               Expected<Value> outcome) {
  auto found = waiting_.find(wait);
  if (found == waiting_.end())
    return {};
  auto waiting = std::move(found->second);
  waiting_.erase(found);
  later_ = std::move(waiting.later);
  code_ = waiting.code;
  origin_ = waiting.origin;
  timers_.cancel_wait(wait);
  // A yielded activation goes on by itself, unless it is being ended.
  auto result =
      waiting.yielded && outcome
          ? interpreter_.run(*waiting.activation, host_)
          : interpreter_.resume(*waiting.activation, std::move(outcome), host_);
  return dispose(std::move(waiting.activation), result);
}

ActivationRunner::WaitFor ActivationRunner::waits_for(WaitId wait) const {
  const auto found = waiting_.find(wait);
  return found == waiting_.end() ? WaitFor::answer : found->second.what;
}

TurnId ActivationRunner::turn_of(WaitId wait) const {
  const auto found = waiting_.find(wait);
  return found == waiting_.end() ? 0 : found->second.activation->context().turn;
}

std::vector<WaitId> ActivationRunner::asked_before(WaitId wait) const {
  std::vector<WaitId> waits;
  const auto asking = waiting_.find(wait);
  if (asking == waiting_.end() || asking->second.what != WaitFor::user ||
      asking->second.activation->context().topic != script::no_id)
    return waits;
  for (const auto& [id, other] : waiting_)
    if (id != wait && other.what == WaitFor::user &&
        other.code == asking->second.code &&
        other.origin.visit == asking->second.origin.visit)
      waits.push_back(id);
  return waits;
}

std::vector<WaitId> ActivationRunner::take_those_of_left_states() {
  std::vector<WaitId> waits;
  for (auto& [id, waiting] : waiting_)
    if (waiting.what != WaitFor::answer && waiting.origin.visit != 0 &&
        !context_.states.lasts(waiting.origin.visit)) {
      waiting.origin.visit = 0;
      waits.push_back(id);
    }
  return waits;
}

bool ActivationRunner::topic_waits() const {
  return std::any_of(waiting_.begin(), waiting_.end(), [](const auto& entry) {
    const auto& [id, waiting] = entry;
    return waiting.what == WaitFor::time &&
           waiting.activation->context().topic != script::no_id;
  });
}

WaitId ActivationRunner::take_slice() {
  if (slices_.empty())
    return 0;
  return slices_.take();
}

Expected<Value> ActivationRunner::evaluate(CodeId code,
                                           const std::vector<Value>& arguments,
                                           TopicId topic) {
  script::ActivationContext context;
  context.topic = topic;
  return interpreter_.evaluate(code, arguments, std::move(context), host_);
}

bool ActivationRunner::holds(CodeId condition,
                             const std::vector<Value>& arguments, TopicId topic,
                             TurnId turn) {
  const auto value = evaluate(condition, arguments, topic);
  if (!value)
    messenger_.script_failed(value.error(), turn);
  return value && *value;
}

WaitId ActivationRunner::begin_wait(WaitFor what) {
  expected_ = {context_.next_id(), what};
  return expected_.id;
}

ActivationRunner::Ran
ActivationRunner::dispose(std::unique_ptr<script::Activation> activation,
                          const script::RunResult& result) {
  using enum script::RunStatus;
  Ran ran;
  if (result.status == failed && report(activation->context(), result))
    ran.failed = activation->context().topic;
  if (result.status == waiting) {
    ran.wait = expected_.id;
    if (leaves_its_state())
      origin_.visit = 0;
    waiting_[ran.wait] = {
        std::move(activation), code_, expected_.what, origin_, false, {}};
  }
  if (result.status == yielded) {
    ran.wait = context_.next_id();
    waiting_[ran.wait] = {
        std::move(activation),    code_, WaitFor::answer, origin_, true,
        std::exchange(later_, {})};
    slices_.push_back(ran.wait);
  }
  expected_ = {};
  return ran;
}

bool ActivationRunner::waits_for_others() const {
  return std::any_of(waiting_.begin(), waiting_.end(), [](const auto& entry) {
    return entry.second.what != WaitFor::user;
  });
}

// What goes on behind its own <transit> or <pop> does not end with the state.
bool ActivationRunner::leaves_its_state() const {
  return std::any_of(later_.begin(), later_.end(), [](const Step& step) {
    return is<steps::Transit>(step) || is<steps::Pop>(step);
  });
}

bool ActivationRunner::report(const script::ActivationContext& context,
                              const script::RunResult& result) {
  auto detail = to_string(result.error);
  for (const auto& line : result.stack)
    detail += "\n  in " + line;
  // To be cancelled is no fault of the script.
  const bool cancelled = result.error.kind == ErrorKind::cancelled;
  context_.inspect(cancelled ? InspectionKind::cancelled
                             : InspectionKind::error,
                   std::string(name_of(result.error.kind)), detail);
  if (!cancelled && !context.handles_error)
    messenger_.raise_error(result.error, context.turn);
  return !cancelled;
}

StepList ActivationRunner::hand_over() {
  if (later_.empty())
    return {};
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
void ActivationRunner::drop(const Step& step) {
  if (const auto* push = std::get_if<steps::Push>(&step))
    context_.lane.queue(outcome_step(
        push->wait, fail(ErrorKind::cancelled, "the state was not entered")));
}

} // namespace parlour::dialogue
