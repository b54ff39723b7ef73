#include "script/exec_host.hpp"

#include <algorithm>

#include "runtime/base/random.hpp"
#include "script/effect_names.hpp"
#include "script/file_effect.hpp"
#include "script/timer_limits.hpp"

namespace parlour::script {

namespace {

// What is due at a time: a timer's body, or an activation that waited.
struct Due {
  Timestamp at = 0;
  std::uint64_t order = 0;
  std::string timer; // its name
  Milliseconds every{0};
  CodeId body = no_code;
  std::vector<Value> arguments;
  std::size_t bytes = 0; // of the arguments
  std::unique_ptr<Activation> waiting;
};

class ExecHost : public Host {
public:
  ExecHost(std::shared_ptr<const Program> program, const ExecOptions& options)
      : options_(options), interpreter_(std::move(program)),
        dice_(options.seed) {
    interpreter_.limit_instructions(options.instructions);
  }

  std::optional<ExecFailure> run();

  Performed perform(Activation& activation, Effect effect) override;
  Value slot(TopicId, SlotId) const override {
    return {};
  }
  void set_slot(TopicId, SlotId, Value) override {}
  Value system(const Activation&, SystemVariable) const override {
    return {};
  }
  bool online(const std::string&) const override {
    return false;
  }
  Timestamp now() const override {
    return now_;
  }
  double random() override {
    return dice_.fraction();
  }

private:
  void begin_event();
  std::optional<ExecFailure> go_on(std::unique_ptr<Activation> activation,
                                   RunResult result);
  std::optional<ExecFailure> run_due(Due due);
  Performed add_timer(const Effect& effect);
  Performed access_file(const FileRequest& request);

  const ExecOptions& options_;
  Interpreter interpreter_;
  Random dice_;
  Timestamp now_ = 0;
  std::uint64_t order_ = 0;
  Milliseconds wait_{0};
  std::vector<Due> due_;
};

void ExecHost::begin_event() {
  now_ = options_.now();
  interpreter_.new_event();
}

Performed ExecHost::add_timer(const Effect& effect) {
  const Milliseconds after(effect.operand(1).integer_or(0));
  Due due;
  due.at = now_ + after.count();
  due.order = ++order_;
  due.timer = effect.operand(0).text();
  due.every = effect.operand(2) ? after : Milliseconds(0);
  due.body = effect.body;
  due.arguments = effect.captured;
  std::erase_if(due_, [&](const Due& other) {
    return !other.waiting && other.timer == due.timer;
  });
  due.bytes = remembered(due.arguments);
  auto bytes = due.bytes;
  for (const auto& other : due_)
    bytes += other.bytes;
  if (auto full = refuse_timers(due_.size() + 1, bytes,
                                interpreter_.program().settings.limits.bytes))
    return std::move(*full);
  due_.push_back(std::move(due));
  return Value();
}

Performed ExecHost::access_file(const FileRequest& request) {
  auto outcome = options_.files(request);
  if (!outcome)
    return std::move(outcome.error());
  return std::move(*outcome);
}

Performed ExecHost::perform(Activation&, Effect effect) {
  const auto most_bytes = interpreter_.program().settings.limits.result;
  if (const auto request = file_request(effect, most_bytes);
      request && options_.files)
    return access_file(*request);
  switch (effect.kind) {
  case EffectKind::print:
    options_.print(effect.operand(0).text());
    return Value();
  case EffectKind::log:
    options_.log(effect.operand(0).text());
    return Value();
  case EffectKind::timer:
    return add_timer(effect);
  case EffectKind::cancel:
    std::erase_if(due_, [&](const Due& due) {
      return !due.waiting && due.timer == effect.operand(0).text();
    });
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

std::optional<ExecFailure>
ExecHost::go_on(std::unique_ptr<Activation> activation, RunResult result) {
  while (result.status == RunStatus::yielded)
    result = interpreter_.run(*activation, *this);
  if (result.status == RunStatus::failed)
    return ExecFailure{std::move(result.error), std::move(result.stack)};
  if (result.status == RunStatus::waiting) {
    Due due;
    due.at = now_ + wait_.count();
    due.order = ++order_;
    due.waiting = std::move(activation);
    due_.push_back(std::move(due));
  }
  return {};
}

std::optional<ExecFailure> ExecHost::run_due(Due due) {
  options_.wait_until(due.at);
  begin_event();
  if (due.waiting) {
    auto result = interpreter_.resume(*due.waiting, Value(), *this);
    return go_on(std::move(due.waiting), std::move(result));
  }
  auto activation = interpreter_.start(due.body, due.arguments, {});
  if (due.every.count() > 0) {
    due.at += due.every.count();
    due.order = ++order_;
    due_.push_back(std::move(due));
  }
  auto result = interpreter_.run(*activation, *this);
  return go_on(std::move(activation), std::move(result));
}

std::optional<ExecFailure> ExecHost::run() {
  const auto& program = interpreter_.program();
  const auto main = program.functions.find("main");
  if (main == program.functions.end())
    return ExecFailure{{ErrorKind::compile, "there is no function 'main'", {}},
                       {}};
  if (const auto& code = program.code[main->second]; code.required_count > 0)
    return ExecFailure{{ErrorKind::compile, "'main' must not have parameters",
                        program.place(code.positions.front())},
                       {}};
  begin_event();
  if (auto ready = interpreter_.initialise(*this); !ready)
    return ExecFailure{std::move(ready.error()), {}};
  auto activation = interpreter_.start(main->second, {}, {});
  auto result = interpreter_.run(*activation, *this);
  auto failure = go_on(std::move(activation), std::move(result));
  while (!failure && !due_.empty()) {
    auto next = std::min_element(
        due_.begin(), due_.end(), [](const Due& a, const Due& b) {
          return a.at != b.at ? a.at < b.at : a.order < b.order;
        });
    auto due = std::move(*next);
    due_.erase(next);
    failure = run_due(std::move(due));
  }
  return failure;
}

} // namespace

std::optional<ExecFailure> run_main(std::shared_ptr<const Program> program,
                                    const ExecOptions& options) {
  return ExecHost(std::move(program), options).run();
}

} // namespace parlour::script
