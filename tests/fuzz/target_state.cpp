// Restores an interpreter from any bytes. If they are accepted, saving and
// restoring again must give the same bytes, and the interpreter must run on
// within its limits.
//
// The input does not contain the header with version and program, so that the
// fuzzer need not guess it. With the argument -corpus=FOLDER the target writes
// real states to that folder.
// them. With the argument -corpus=FOLDER real states are written there.
#include <cstdlib>
#include <fstream>

#include "script/compiler/compiler.hpp"
#include "tests/fuzz/quiet_host.hpp"

namespace parlour::fuzz {

namespace {

constexpr std::size_t header = 9;
constexpr std::uint64_t fuel = 2000;

std::shared_ptr<const script::Program> program() {
  static const auto compiled = script::compile_file(
      PARLOUR_SOURCE_DIR "/tests/fuzz/state_program.xml", {});
  if (!compiled.program)
    std::abort();
  return compiled.program;
}

std::string save(const script::Restored& state) {
  std::vector<const script::Activation*> activations;
  for (const auto& activation : state.activations)
    activations.push_back(activation.get());
  return state.interpreter.save(activations);
}

// Writes the state at the start and after each step.
void write_states(const std::filesystem::path& folder) {
  QuietHost host;
  script::Interpreter interpreter(program());
  interpreter.set_slice(1);
  interpreter.limit_instructions(fuel);
  interpreter.new_event();
  if (!interpreter.initialise(host))
    std::abort();
  const auto code = program()->functions.at("main");
  const auto activation = interpreter.start(code, {}, {});
  auto result = interpreter.run(*activation, host);
  for (int i = 0; i < 60; ++i) {
    std::ofstream(folder / ("state-" + std::to_string(i)), std::ios::binary)
        << interpreter.save({activation.get()}).substr(header);
    if (result.status == script::RunStatus::yielded)
      result = interpreter.run(*activation, host);
    else if (result.status == script::RunStatus::waiting)
      result = interpreter.resume(*activation, Value(i), host);
    else
      return;
  }
}

void go_on(script::Restored& state) {
  QuietHost host;
  for (const auto& activation : state.activations) {
    state.interpreter.limit_instructions(fuel);
    state.interpreter.new_event();
    QuietHost::finish(state.interpreter, *activation,
                      state.interpreter.resume(*activation, Value(1), host),
                      host);
  }
}

} // namespace

} // namespace parlour::fuzz

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  const std::string option = "-corpus=";
  const std::string last = (*arguments)[*count - 1];
  if (last.starts_with(option)) {
    parlour::fuzz::write_states(last.substr(option.size()));
    std::exit(0);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using parlour::script::Interpreter;
  static const auto start = Interpreter(parlour::fuzz::program())
                                .save({})
                                .substr(0, parlour::fuzz::header);
  const auto bytes =
      start + std::string(reinterpret_cast<const char*>(data), size);
  auto state = Interpreter::restore(parlour::fuzz::program(), bytes);
  if (!state)
    return 0;
  const auto once = parlour::fuzz::save(*state);
  auto again = Interpreter::restore(parlour::fuzz::program(), once);
  if (!again || parlour::fuzz::save(*again) != once)
    std::abort();
  parlour::fuzz::go_on(*state);
  return 0;
}
