// Parameters of commands and events as data, read from the texts in roles.def.
// Role plug-ins, the conformance test and the skeletons of new plug-ins use it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/value.hpp"

namespace parlour {

// clang-format off
#define PARLOUR_PARAMETER_KINDS(X) \
  X(value, "any value") \
  X(text, "a text") \
  X(integer, "a whole number") \
  X(number, "a number") \
  X(boolean, "true or false") \
  X(list, "a list") \
  X(map, "a map") \
  X(audio, "audio (binary)") \
  X(rows, "rows of a query")
// clang-format on

enum class ParameterKind : std::uint8_t {
#define X(name, sentence) name,
  PARLOUR_PARAMETER_KINDS(X)
#undef X
};

std::string_view sentence_of(ParameterKind kind);

struct Parameter {
  std::string name;
  ParameterKind kind = ParameterKind::value;
  bool optional = false; // "context?"
  bool repeats = false;  // "act..."
};

// Reads a text of the table, such as "text, context?" or "act...".
std::vector<Parameter> read_parameters(std::string_view text);

// A value of the parameter's kind for trying a command; the same for each call.
Value sample_of(const Parameter& parameter);

// Read a parameter as the type that a handler wants. They return false, and
// leave `to` unspecified, if the value is something else. Conversions are
// lenient where speech needs it: a text that reads as a number is a number, and
// a number is a text.
bool read(const Value& value, std::string& to);
bool read(const Value& value, std::int64_t& to);
bool read(const Value& value, double& to);
bool read(const Value& value, bool& to);
bool read(const Value& value, List& to);
bool read(const Value& value, Map& to);
bool read(const Value& value, Binary& to);
bool read(const Value& value, ResultSet& to);
bool read(const Value& value, Value& to);

} // namespace parlour
