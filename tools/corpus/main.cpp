// corpus_runner APPLICATION < turns
//
// Plays the dialogues that tools/corpus/run writes with the dialogue engine.
// Prints a line for each event: `begin` with the name of a dialogue (so that a
// crash can be located), each fault, and at the end `total` with the counts.
// The exit status is 0 unless the input or the application is wrong; faults do
// not change it.
#include <iostream>

#include "script/compiler/compiler.hpp"
#include "tools/corpus/player.hpp"

namespace {

using namespace parlour;
using namespace parlour::tools::corpus;

// A tab or line break within a field would break the line.
std::string field(std::string text) {
  for (auto& character : text)
    if (character == '\t' || character == '\n' || character == '\r')
      character = ' ';
  return text;
}

void print(const Fault& fault) {
  std::cout << name_of(fault.kind);
  for (const auto* text : {&fault.dialogue, &fault.turn, &fault.topic,
                           &fault.slot, &fault.wanted, &fault.found})
    std::cout << '\t' << field(*text);
  std::cout << '\n';
}

void print(const Counts& counts) {
  std::cout << "total\t" << counts.dialogues << '\t' << counts.turns << '\t'
            << counts.states << '\t' << counts.slots << '\t' << counts.returns
            << '\n';
}

int play_all(std::shared_ptr<const script::Program> program) {
  Player player(std::move(program), [](const Fault& fault) { print(fault); });
  TurnReader reader(std::cin);
  for (;;) {
    const auto lines = reader.next();
    if (!lines) {
      std::cerr << "line " << lines.error().place.line << ": "
                << lines.error().message << '\n';
      return 2;
    }
    if (lines->empty())
      break;
    // Flushed, so that it is visible even if the dialogue crashes.
    std::cout << "begin\t" << lines->front().fields[0] << std::endl;
    player.play(*lines);
  }
  print(player.counts());
  return 0;
}

} // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: corpus_runner APPLICATION < turns\n";
    return 2;
  }
  script::CompileOptions options;
  options.platform = PARLOUR_PLATFORM;
  auto compiled = script::compile_application(arguments[1], options);
  if (!compiled.program) {
    for (const auto& finding : compiled.findings.all())
      std::cerr << script::to_string(finding) << '\n';
    return 2;
  }
  return play_all(compiled.program);
}
