// BodyCompiler: the border between the compiler of declarations (topics,
// states, handlers …) and the compiler of code (statements, expressions). The
// former calls it for every body and attribute that runs; what is declared
// must be registered in Names before.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "script/program/program.hpp"
#include "script/source/findings.hpp"

namespace parlour::script {

struct FunctionName {
  CodeId code = no_code; // reserved before bodies are compiled
  std::uint16_t required = 0;
  std::uint16_t parameters = 0;
  std::vector<std::string> parameter_names; // for <call> with named arguments
  Position position;
};

using FunctionNames = std::map<std::string, FunctionName, std::less<>>;

// Everything declared in the application, collected before any code is made.
struct Names {
  FunctionNames functions; // session-wide
  std::map<std::string, std::uint32_t, std::less<>> variables;
  std::map<std::string, Position, std::less<>> states;
  std::map<std::string, Position, std::less<>> topics;
  std::map<std::string, Position, std::less<>> handlers;
};

using ElementNames = std::initializer_list<std::string_view>;

// Where a body stands.
struct BodyContext {
  const Topic* topic = nullptr;             // `this` is its frame
  const FunctionNames* functions = nullptr; // of the state or topic
  bool in_timer = false;
  bool handles_message = false; // _LPARAM1 may hold something
  std::string name;             // for the script stack
};

class BodyCompiler {
public:
  BodyCompiler(Program& program, const Names& names, Findings& findings);

  // The statements inside `parent` (all children but those named in
  // `except`), as code without parameters or with the given ones.
  CodeId body(const Element& parent, const BodyContext& context,
              const std::vector<std::string>& parameters = {},
              ElementNames except = {});
  // A <function>: its <param>s and statements, into the reserved code.
  void function(const Element& element, CodeId reserved,
                const BodyContext& context);

  // Language rule 4. An expression; text or expression; text with {expr}.
  CodeId expression(const Attribute& attribute, const BodyContext& context,
                    const std::vector<std::string>& parameters = {});
  CodeId text_or_expression(const Attribute& attribute,
                            const BodyContext& context);
  CodeId text(const std::string& text, Position position,
              const BodyContext& context,
              const std::vector<std::string>& parameters = {});

private:
  Program& program_;
  const Names& names_;
  Findings& findings_;
};

} // namespace parlour::script
