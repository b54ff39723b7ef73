#include "script/dialogue/context/activation_runner.hpp"

#include <algorithm>
#include <utility>

namespace parlour::dialogue {

ActivationRunner::Ran
ActivationRunner::start(CodeId code, const std::vector<Value>& arguments,
                        script::ActivationContext context, Origin origin) {
  running_.begins(code, origin);
  auto stopped =
      interpreter_.run_body(code, arguments, std::move(context), host_);
  return stopped ? dispose(std::move(stopped->activation), stopped->result)
                 : Ran();
}

// The entry goes before the script runs: what the script does may end other
// waits, and this one may wait again under another id.
ActivationRunner::Ran ActivationRunner::resume(WaitId wait,
                                               Expected<Value> outcome) {
  auto found = waiting_.find(wait);
  if (found == waiting_.end())
    return {};
  auto waiting = std::move(found->second);
  waiting_.erase(found);
  running_.goes_on(waiting.code, waiting.origin, std::move(waiting.later));
  timers_.cancel_wait(wait);
  // A yielded activation goes on by itself, unless it is being ended.
  auto result =
      waiting.yielded && outcome
          ? interpreter_.run(*waiting.activation, host_)
          : interpreter_.resume(*waiting.activation, std::move(outcome), host_);
  return dispose(std::move(waiting.activation), result);
}

WaitFor ActivationRunner::waits_for(WaitId wait) const {
  const auto found = waiting_.find(wait);
  return found == waiting_.end() ? WaitFor::answer : found->second.what;
}

TurnId ActivationRunner::turn_of(WaitId wait) const {
  const auto found = waiting_.find(wait);
  return found == waiting_.end() ? 0 : found->second.activation->context().turn;
}

// A handler that asks "Did you say 5?" and then gets other words asks about
// these. The earlier question of the same statements is given up then (engine
// rule 2.4). A topic's scripts are left alone: theirs are ended by
// Confirmations.
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

// A script that waits for a component still gets its answer. One that waits for
// the user or for time has no more use for it. The origin is forgotten, so that
// none is told twice.
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

ActivationRunner::Ran
ActivationRunner::dispose(std::unique_ptr<script::Activation> activation,
                          const script::RunResult& result) {
  using enum script::RunStatus;
  Ran ran;
  if (result.status == failed && report(activation->context(), result))
    ran.failed = activation->context().topic;
  const auto wait = running_.take_wait();
  auto origin = running_.origin();
  if (result.status == waiting) {
    ran.wait = wait.id;
    if (running_.leaves_its_state())
      origin.visit = 0;
    waiting_[ran.wait] = {
        std::move(activation), running_.body(), wait.what, origin, false, {}};
  }
  if (result.status == yielded) {
    ran.wait = context_.next_id();
    waiting_[ran.wait] = {
        std::move(activation), running_.body(), WaitFor::answer, origin, true,
        running_.take_later()};
    slices_.push_back(ran.wait);
  }
  return ran;
}

bool ActivationRunner::waits_for_others() const {
  return std::any_of(waiting_.begin(), waiting_.end(), [](const auto& entry) {
    return entry.second.what != WaitFor::user;
  });
}

// The error is shown with the stack of calls, and raised as Script.Error unless
// the script that failed handles a Script.Error itself: it would be called for
// ever.
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

} // namespace parlour::dialogue
