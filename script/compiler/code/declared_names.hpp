// What is declared in an application, by name: known before any body is
// compiled, and what of it a body sees.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "script/program/program.hpp"

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

} // namespace parlour::script
