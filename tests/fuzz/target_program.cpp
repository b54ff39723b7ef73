// Makes a program (program_maker.hpp) and runs it twice: at one go, and with an
// interpreter that is saved and restored at some steps, which the last byte
// chooses. Both runs must print the same.
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "script/compiler/compiler.hpp"
#include "tests/fuzz/program_maker.hpp"
#include "tests/script/script_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

void expect(bool holds, const std::string& script, const std::string& why) {
  if (holds)
    return;
  std::fprintf(stderr, "%s\n%s\n", script.c_str(), why.c_str());
  std::abort();
}

std::string text_of(const parlour::test::ScriptRun& run) {
  auto text = run.printed;
  for (const auto& [line, said] : run.errors)
    text += std::to_string(line) + ": " + said + '\n';
  return text;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace parlour;
  constexpr std::uint64_t fuel = 1000;
  static const test::TemporaryFolder folder;
  const auto script =
      fuzz::ProgramMaker({reinterpret_cast<const char*>(data), size}).make();
  folder.write("a.xml", script);
  const auto compiled = script::compile_file(folder.path() / "a.xml", {});
  for (const auto& finding : compiled.findings.all())
    expect(compiled.program != nullptr, script, to_string(finding));
  const auto once = test::run_script(compiled.program, fuel);
  const test::RestoredStops stops{size ? data[size - 1] % 64 : 0, 4};
  const auto again = test::run_with_restores(compiled.program, fuel, stops);
  expect(once == again, script,
         "at one go:\n" + text_of(once) + "with restores:\n" + text_of(again));
  return 0;
}
