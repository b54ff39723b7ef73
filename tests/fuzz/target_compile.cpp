// Compiles any text as a script. If it compiles, each function runs within
// limits.
#include <fstream>

#include "script/compiler/compiler.hpp"
#include "tests/fuzz/quiet_host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::fuzz {

namespace {

void run_every_function(const std::shared_ptr<const script::Program>& program) {
  script::Interpreter interpreter(program);
  QuietHost host;
  interpreter.limit_instructions(2000);
  interpreter.new_event();
  if (!interpreter.initialise(host))
    return;
  for (script::CodeId code = 0; code < program->code.size(); ++code) {
    interpreter.new_event();
    const std::vector<Value> arguments(program->code[code].parameter_count,
                                       Value("x"));
    const auto activation = interpreter.start(code, arguments, {});
    QuietHost::finish(interpreter, *activation,
                      interpreter.run(*activation, host), host);
  }
}

} // namespace

} // namespace parlour::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  static const parlour::test::TemporaryFolder folder;
  static const auto file = folder.path() / "a.xml";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data),
             static_cast<std::streamsize>(size));
  const auto compiled = parlour::script::compile_file(file, {});
  for (const auto& finding : compiled.findings.all())
    parlour::script::to_string(finding);
  if (compiled.program)
    parlour::fuzz::run_every_function(compiled.program);
  return 0;
}
