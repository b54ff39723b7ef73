// One activation runs at a time. It ends, yields (and goes on with the next
// step) or waits (and is put into the list of what is due).

#include "script/run/exec_run.hpp"

#include <algorithm>

#include "script/program/effect_names.hpp"
#include "script/program/file_effect.hpp"
#include "script/program/timer_limits.hpp"

namespace parlour::script {

ExecRun::ExecRun(std::shared_ptr<const Program> program, ExecOptions options)
    : options_(std::move(options)), interpreter_(std::move(program)),
      dice_(options_.seed) {
  interpreter_.limit_instructions(options_.instructions);
}

// -- effects ------------------------------------------------------------------

// A timer that has rung is not in the list any more; waits have no name.
void ExecRun::cancel(const std::string& timer) {
  std::erase_if(
      due_, [&](const Due& due) { return !due.waiting && due.timer == timer; });
}

// A timer replaces one of its name (language rule 10.3). The period of a
// repeating timer is at least 1 ms, so that time passes.
Performed ExecRun::add_timer(const Effect& effect) {
  const Milliseconds after(effect.operand(1).integer_or(0));
  Due due;
  due.at = later(now_, after);
  due.order = ++order_;
  due.timer = effect.text(0);
  due.every = effect.operand(2)
                  ? std::clamp(after, Milliseconds(1), Milliseconds(latest))
                  : Milliseconds(0);
  due.body = effect.body;
  due.arguments = effect.captured();
  due.bytes = remembered(due.arguments);
  cancel(due.timer);
  auto bytes = due.bytes;
  for (const auto& other : due_)
    bytes += other.bytes;
  if (auto full = refuse_timers(due_.size() + 1, bytes,
                                interpreter_.program().settings.limits.bytes))
    return std::move(*full);
  due_.push_back(std::move(due));
  return Value();
}

Performed ExecRun::access_file(const FileRequest& request) {
  auto outcome = options_.files(request);
  if (!outcome)
    return std::move(outcome.error());
  return std::move(*outcome);
}

// File effects are carried out at once, as nothing else can run meanwhile.
Performed ExecRun::perform(Activation&, const Effect& effect) {
  const auto max_bytes = interpreter_.program().settings.limits.result;
  if (const auto request = file_request(effect, max_bytes);
      request && options_.files)
    return access_file(*request);
  switch (effect.kind) {
  case EffectKind::print:
    options_.print(effect.text(0));
    return Value();
  case EffectKind::log:
    options_.log(effect.text(0));
    return Value();
  case EffectKind::timer:
    return add_timer(effect);
  case EffectKind::cancel:
    cancel(effect.text(0));
    return Value();
  case EffectKind::wait:
    wait_ = Milliseconds(effect.operand(0).integer_or(0));
    return Waits{};
  default:
    return Error{ErrorKind::refused,
                 "<" + element_of(effect.kind) +
                     "> needs a running application",
                 {}};
  }
}

// -- running ------------------------------------------------------------------

void ExecRun::begin_event() {
  now_ = options_.now();
  interpreter_.new_event();
}

// Deals with how the current activation stopped.
void ExecRun::go_on(RunResult result) {
  if (result.status == RunStatus::yielded)
    return;
  if (result.status == RunStatus::failed)
    failure_ = ExecFailure{std::move(result.error), std::move(result.stack)};
  if (result.status == RunStatus::waiting) {
    Due due;
    due.at = later(now_, wait_);
    due.order = ++order_;
    due.waiting = std::move(current_);
    due_.push_back(std::move(due));
  }
  current_.reset();
}

// The session variables are initialised first, within main's event.
void ExecRun::start_main() {
  started_ = true;
  const auto& program = interpreter_.program();
  const auto main = program.functions.find("main");
  if (main == program.functions.end()) {
    failure_ = {{ErrorKind::compile, "there is no function 'main'", {}}, {}};
    return;
  }
  const auto& code = program.code[main->second];
  if (code.required_count > 0) {
    failure_ = {{ErrorKind::compile, "'main' must not have parameters",
                 program.place(code.positions.front())},
                {}};
    return;
  }
  begin_event();
  if (auto ready = interpreter_.initialise(*this); !ready) {
    failure_ = {std::move(ready.error()), {}};
    return;
  }
  current_ = interpreter_.start(main->second, {}, {});
  go_on(interpreter_.run(*current_, *this));
}

// The earliest; of several at one time the one that was set first.
ExecRun::Due ExecRun::take_next() {
  const auto next = std::min_element(
      due_.begin(), due_.end(), [](const Due& a, const Due& b) {
        return a.at != b.at ? a.at < b.at : a.order < b.order;
      });
  auto due = std::move(*next);
  due_.erase(next);
  return due;
}

// A repeating timer is set again before its body runs, counted from the time at
// which it was due, so that its period does not drift.
void ExecRun::run_due(Due due) {
  options_.wait_until(due.at);
  begin_event();
  if (due.waiting) {
    current_ = std::move(due.waiting);
    return go_on(interpreter_.resume(*current_, Value(), *this));
  }
  current_ = interpreter_.start(due.body, due.arguments, {});
  // The body was started, so the timer's entry can be moved.
  if (due.every.count() > 0) {
    due.at = later(due.at, due.every);
    due.order = ++order_;
    due_.push_back(std::move(due));
  }
  go_on(interpreter_.run(*current_, *this));
}

// What has yielded goes on first, so one event is finished before the next one
// begins.
bool ExecRun::step() {
  if (failure_)
    return false;
  if (current_)
    go_on(interpreter_.run(*current_, *this));
  else if (!started_)
    start_main();
  else if (!due_.empty())
    run_due(take_next());
  else
    return false;
  return true;
}

std::optional<ExecFailure> run_main(std::shared_ptr<const Program> program,
                                    ExecOptions options) {
  ExecRun run(std::move(program), std::move(options));
  while (run.step()) {
  }
  return run.failure();
}

} // namespace parlour::script
