#include "tools/bench/script/script_workload.hpp"

#include <limits>

#include "script/compiler/compiler.hpp"
#include "script/program/computing_host.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::tools {

namespace {

// A host on which every effect waits.
class WaitingHost : public script::LonelyHost {
public:
  script::Performed perform(script::Activation&,
                            const script::Effect&) override {
    return script::Waits{};
  }
  Timestamp now() const override {
    return 0;
  }
  double random() override {
    return 0;
  }
};

// The limit on instructions is lifted: a workload is longer than any event.
Expected<void> ready(script::Interpreter& interpreter, WaitingHost& host) {
  interpreter.limit_instructions(std::numeric_limits<std::int64_t>::max());
  interpreter.new_event();
  return interpreter.initialise(host);
}

// The constant `operations` of the script; 1 if it has none.
double operations(const script::Interpreter& interpreter) {
  const auto& variables = interpreter.program().variables;
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (variables[i].name == "operations")
      return interpreter.variable(i).number_or(1);
  return 1;
}

// Runs the script to its end, resuming it after each wait and each slice.
script::RunResult finish(script::Interpreter& interpreter,
                         script::Activation& activation, WaitingHost& host) {
  bool waiting = false;
  for (;;) {
    auto result = waiting ? interpreter.resume(activation, Value(), host)
                          : interpreter.run(activation, host);
    waiting = result.status == script::RunStatus::waiting;
    if (!waiting && result.status != script::RunStatus::yielded)
      return result;
  }
}

} // namespace

Expected<ScriptWorkload>
ScriptWorkload::load(const std::filesystem::path& file) {
  auto compiled = script::compile_file(file, {});
  if (!compiled.program)
    return fail(ErrorKind::compile,
                script::to_string(compiled.findings.all().front()));
  if (compiled.program->functions.count("work") == 0)
    return fail(ErrorKind::compile, file.string() + " has no function 'work'");
  return ScriptWorkload(std::move(compiled.program));
}

Expected<Measured> ScriptWorkload::run() const {
  WaitingHost host;
  script::Interpreter interpreter(program_);
  if (auto begun = ready(interpreter, host); !begun)
    return tl::make_unexpected(begun.error());
  const auto work = program_->functions.find("work")->second;
  auto activation = interpreter.start(work, {}, {});
  const auto start = cpu_nanoseconds();
  const auto result = finish(interpreter, *activation, host);
  const auto spent = cpu_nanoseconds() - start;
  if (result.status == script::RunStatus::failed)
    return tl::make_unexpected(result.error);
  return Measured{spent / operations(interpreter), result.value.text()};
}

Expected<double> ScriptWorkload::suspended_bytes() const {
  // Enough that the overhead of the vector does not matter.
  constexpr std::size_t many = 10000;
  WaitingHost host;
  script::Interpreter interpreter(program_);
  if (auto begun = ready(interpreter, host); !begun)
    return tl::make_unexpected(begun.error());
  const auto work = program_->functions.find("work")->second;
  std::vector<std::unique_ptr<script::Activation>> waiting(many);
  const auto before = bytes_in_use();
  for (auto& activation : waiting) {
    activation = interpreter.start(work, {Value(1)}, {});
    if (auto result = interpreter.run(*activation, host);
        result.status == script::RunStatus::failed)
      return tl::make_unexpected(result.error);
  }
  return static_cast<double>(bytes_in_use() - before) / many;
}

} // namespace parlour::tools
