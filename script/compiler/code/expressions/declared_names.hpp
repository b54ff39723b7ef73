// What is declared in an application, by name. It is complete before any body
// is compiled.
//
// A reserved CodeId makes it possible to compile calls before their callee, so
// functions may call each other in any order.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "script/program/program.hpp"

namespace parlour::script {

// A function's head, as far as calls need it.
struct FunctionName {
  CodeId code = no_code; // reserved before bodies are compiled
  std::uint16_t required = 0;
  std::uint16_t parameters = 0;
  std::vector<std::string> parameter_names; // for <call> with named arguments
  Position position;
};

using FunctionNames = std::map<std::string, FunctionName, std::less<>>;

// All names of an application, for resolving them and for "did you mean".
struct Names {
  FunctionNames functions; // session-wide
  std::map<std::string, std::uint32_t, std::less<>> variables;
  std::map<std::string, Position, std::less<>> states;
  std::map<std::string, Position, std::less<>> topics;
  std::map<std::string, Position, std::less<>> handlers;
};

using ElementNames = std::initializer_list<std::string_view>;

// The surroundings of a body, which decide what it sees.
struct BodyContext {
  const Topic* topic = nullptr;             // whose slots `this` means
  const FunctionNames* functions = nullptr; // of the state or topic
  bool in_timer = false;
  bool handles_message = false; // _LPARAM1 may hold something
  std::string name;             // for the script stack
};

} // namespace parlour::script
