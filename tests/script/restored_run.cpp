#include <algorithm>
#include <optional>

#include "runtime/base/random.hpp"
#include "runtime/base/value_bytes.hpp"
#include "script/effect_names.hpp"
#include "script/file_effect.hpp"
#include "script/interpreter.hpp"
#include "script/timer_limits.hpp"
#include "tests/script/script_run.hpp"

namespace parlour::test {

namespace {

using script::Activation;
using script::CodeId;
using script::Effect;
using script::EffectKind;
using script::RunResult;
using script::RunStatus;

// Restores after that many stops are left to chance, as a script that runs
// into a limit stops a hundred thousand times.
constexpr int restored_stops = 150;
constexpr std::uint64_t later_slice = 10'000;

struct Due {
  Timestamp at = 0;
  std::uint64_t order = 0;
  std::string timer;
  std::int64_t every = 0;
  CodeId body = script::no_code;
  std::string arguments; // the bytes of a list
  std::unique_ptr<Activation> waiting;
};

class RestoredRun : public script::Host {
public:
  RestoredRun(std::shared_ptr<const script::Program> program,
              std::uint64_t instructions, FileAccess files)
      : program_(std::move(program)), interpreter_(program_),
        files_(std::move(files)) {
    interpreter_.limit_instructions(instructions);
    interpreter_.set_slice(1);
  }

  ScriptRun run();

  script::Performed perform(Activation&, Effect effect) override;
  Value slot(script::TopicId, script::SlotId) const override {
    return {};
  }
  void set_slot(script::TopicId, script::SlotId, Value) override {}
  Value system(const Activation&, script::SystemVariable) const override {
    return {};
  }
  bool online(const std::string&) const override {
    return false;
  }
  Timestamp now() const override {
    return clock_;
  }
  double random() override {
    return dice_.fraction();
  }

private:
  bool run_to_end(CodeId code, const std::vector<Value>& arguments);
  bool go_on(RunResult result);
  bool run_due(Due due);
  void restore();
  script::Performed add_timer(const Effect& effect);
  script::Performed access_file(const FileRequest& request);
  void cancel(const std::string& timer);
  bool note(const Error& error);
  void differs(const std::string& what) {
    run_.errors.push_back({0, what});
  }

  std::shared_ptr<const script::Program> program_;
  script::Interpreter interpreter_;
  FileAccess files_;
  std::unique_ptr<Activation> current_;
  std::vector<Due> due_;
  Random dice_{1};
  Timestamp clock_ = 1'795'251'600'000;
  std::uint64_t order_ = 0;
  std::int64_t wait_ = 0;
  int stops_ = 0;
  ScriptRun run_;
};

// Always false.
bool RestoredRun::note(const Error& error) {
  run_.errors.push_back({error.place.line, std::string(name_of(error.kind)) +
                                               ": " + error.message});
  return false;
}

void RestoredRun::cancel(const std::string& timer) {
  std::erase_if(
      due_, [&](const Due& due) { return !due.waiting && due.timer == timer; });
}

script::Performed RestoredRun::add_timer(const Effect& effect) {
  cancel(effect.operand(0).text());
  auto bytes = script::remembered(effect.captured);
  for (const auto& due : due_)
    bytes += due.arguments.size();
  if (auto full = script::refuse_timers(due_.size() + 1, bytes,
                                        program_->settings.limits.bytes))
    return std::move(*full);
  const auto after = effect.operand(1).integer_or(0);
  due_.push_back({clock_ + after, ++order_, effect.operand(0).text(),
                  effect.operand(2) ? after : 0, effect.body,
                  to_bytes(effect.captured), nullptr});
  return Value();
}

script::Performed RestoredRun::access_file(const FileRequest& request) {
  auto outcome = files_(request);
  if (!outcome)
    return std::move(outcome.error());
  return std::move(*outcome);
}

script::Performed RestoredRun::perform(Activation&, Effect effect) {
  if (const auto request =
          script::file_request(effect, program_->settings.limits.result);
      request && files_)
    return access_file(*request);
  switch (effect.kind) {
  case EffectKind::print:
    run_.printed += effect.operand(0).text() + '\n';
    return Value();
  case EffectKind::log:
    return Value();
  case EffectKind::timer:
    return add_timer(effect);
  case EffectKind::cancel:
    cancel(effect.operand(0).text());
    return Value();
  case EffectKind::wait:
    wait_ = effect.operand(0).integer_or(0);
    return script::Waits{};
  default:
    return Error{ErrorKind::refused,
                 "<" + script::element_of(effect.kind) +
                     "> needs a running application",
                 {}};
  }
}

// Every activation there is, and back into the places they came from.
void RestoredRun::restore() {
  std::vector<std::unique_ptr<Activation>*> places;
  if (current_)
    places.push_back(&current_);
  for (auto& due : due_)
    if (due.waiting)
      places.push_back(&due.waiting);
  std::vector<const Activation*> activations;
  for (const auto* place : places)
    activations.push_back(place->get());
  const auto bytes = interpreter_.save(activations);
  auto restored = script::Interpreter::restore(program_, bytes);
  if (!restored)
    return differs(restored.error().message);
  std::vector<const Activation*> again;
  for (const auto& activation : restored->activations)
    again.push_back(activation.get());
  if (restored->interpreter.save(again) != bytes)
    differs("the restored state has other bytes");
  if (restored->interpreter.bytes_held() != interpreter_.bytes_held())
    differs("the restored state holds other memory");
  for (std::size_t i = 0; i < places.size(); ++i)
    *places[i] = std::move(restored->activations[i]);
  interpreter_ = std::move(restored->interpreter);
  interpreter_.set_slice(stops_ < restored_stops ? 1 : later_slice);
}

bool RestoredRun::go_on(RunResult result) {
  for (; result.status == RunStatus::yielded; ++stops_) {
    restore();
    result = interpreter_.run(*current_, *this);
  }
  if (result.status == RunStatus::failed)
    return note(result.error);
  if (result.status == RunStatus::waiting)
    due_.push_back({clock_ + wait_, ++order_, "", 0, script::no_code, "",
                    std::move(current_)});
  current_.reset();
  restore();
  return true;
}

bool RestoredRun::run_to_end(CodeId code, const std::vector<Value>& arguments) {
  current_ = interpreter_.start(code, arguments, {});
  return go_on(interpreter_.run(*current_, *this));
}

bool RestoredRun::run_due(Due due) {
  clock_ = std::max(clock_, due.at);
  interpreter_.new_event();
  if (due.waiting) {
    current_ = std::move(due.waiting);
    return go_on(interpreter_.resume(*current_, Value(), *this));
  }
  const auto code = due.body;
  const auto arguments = value_from_bytes(due.arguments);
  if (due.every > 0) {
    due.at += due.every;
    due.order = ++order_;
    due_.push_back(std::move(due));
  }
  return run_to_end(code, *arguments->if_list());
}

ScriptRun RestoredRun::run() {
  const auto main = program_->functions.find("main");
  if (main == program_->functions.end()) {
    note({ErrorKind::compile, "there is no function 'main'", {}});
    return run_;
  }
  const auto& code = program_->code[main->second];
  if (code.required_count > 0) {
    note({ErrorKind::compile, "'main' must not have parameters",
          program_->place(code.positions.front())});
    return run_;
  }
  interpreter_.new_event();
  if (auto ready = interpreter_.initialise(*this); !ready) {
    note(ready.error());
    return run_;
  }
  bool well = run_to_end(main->second, {});
  while (well && !due_.empty()) {
    auto next = std::min_element(
        due_.begin(), due_.end(), [](const Due& a, const Due& b) {
          return a.at != b.at ? a.at < b.at : a.order < b.order;
        });
    auto due = std::move(*next);
    due_.erase(next);
    well = run_due(std::move(due));
  }
  return run_;
}

} // namespace

ScriptRun
run_with_restores(const std::shared_ptr<const script::Program>& program,
                  std::uint64_t instructions, const FileAccess& files) {
  return RestoredRun(program, instructions, files).run();
}

} // namespace parlour::test
