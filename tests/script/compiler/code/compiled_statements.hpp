// Compiles statements, for the tests of the groups of statements.
#pragma once

#include <string>

#include "script/program/host.hpp"
#include "tests/script/script_run.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::test {

// The first finding about the statements of a function; empty if there is none.
inline std::string finding(const std::string& statements) {
  const auto lines =
      compile_declarations("<function name='f'>" + statements + "</function>")
          .lines;
  return lines.empty() ? "" : lines[0];
}

// What the statements print as the body of main, or the first error.
inline std::string printed(const std::string& statements) {
  const auto outcome = compile_declarations("<function name='main'>" +
                                            statements + "</function>");
  if (!outcome.program)
    return outcome.lines.at(0);
  const auto run = run_script(outcome.program);
  return run.errors.empty() ? run.printed : run.errors[0].text;
}

// Whether any body of the program performs such an effect.
inline bool has_effect(const Outcome& outcome, script::EffectKind kind) {
  for (const auto& code : outcome.program->code)
    for (const auto& shape : code.effects)
      if (shape.kind == static_cast<std::uint8_t>(kind))
        return true;
  return false;
}

} // namespace parlour::test
