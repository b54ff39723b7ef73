// Reading the notation of roles.def ("text, context?", "act...") and converting
// values to the types that handlers take.

#include "runtime/plugin/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parlour {

namespace {

// The kind of a parameter by its name (parameters.def); any value if it is not
// listed.
ParameterKind kind_of(std::string_view parameter) {
  using Entry = std::pair<std::string_view, ParameterKind>;
  constexpr Entry table[] = {
#define PARAMETER(name, kind) {#name, ParameterKind::kind},
#include "runtime/plugin/parameters.def"
#undef PARAMETER
  };
  for (const auto& [name, kind] : table)
    if (name == parameter)
      return kind;
  return ParameterKind::value;
}

// Removes a suffix and tells whether it was there.
bool take_end(std::string_view& text, std::string_view end) {
  if (!text.ends_with(end))
    return false;
  text.remove_suffix(end.size());
  return true;
}

// A name with its marks: `?` for optional, `...` for repeated.
Parameter read_parameter(std::string_view text) {
  while (text.starts_with(' '))
    text.remove_prefix(1);
  Parameter parameter;
  parameter.optional = take_end(text, "?");
  parameter.repeats = take_end(text, "...");
  parameter.name = text;
  parameter.kind = kind_of(text);
  return parameter;
}

// 20 ms of silence.
Binary silence() {
  return {"pcm_s16le;rate=16000;channels=1", std::vector<std::byte>(640)};
}

template <class T>
bool copy(const T* from, T& to) {
  if (from)
    to = *from;
  return from != nullptr;
}

} // namespace

std::string_view sentence_of(ParameterKind kind) {
  constexpr std::string_view sentences[] = {
#define X(name, sentence) sentence,
      PARLOUR_PARAMETER_KINDS(X)
#undef X
  };
  return sentences[static_cast<std::size_t>(kind)];
}

std::vector<Parameter> read_parameters(std::string_view text) {
  std::vector<Parameter> parameters;
  while (!text.empty()) {
    const auto end = std::min(text.find(','), text.size());
    parameters.push_back(read_parameter(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parameters;
}

// Statements of SQL need a text that a database accepts; for all others any
// text will do.
Value sample_of(const Parameter& parameter) {
  switch (parameter.kind) {
  case ParameterKind::value:
  case ParameterKind::text:
    return parameter.name == "sql" ? Value("select 1") : Value("hello");
  case ParameterKind::integer:
    return 1;
  case ParameterKind::number:
    return 0.5;
  case ParameterKind::boolean:
    return false;
  case ParameterKind::list:
    return List{};
  case ParameterKind::map:
    return Map{};
  case ParameterKind::audio:
    return silence();
  case ParameterKind::rows:
    return ResultSet{};
  }
  return {};
}

// Numbers and booleans are accepted as text; lists and maps are not.
bool read(const Value& value, std::string& to) {
  switch (value.type()) {
  case ValueType::string:
  case ValueType::integer:
  case ValueType::number:
  case ValueType::boolean:
    to = value.text();
    return true;
  default:
    return false;
  }
}

// A text that is written like a number counts as one.
bool read(const Value& value, double& to) {
  const auto number =
      value.if_string() ? parse_number(*value.if_string()) : value;
  if (!number.if_integer() && !number.if_number())
    return false;
  to = number.number_or(0);
  return true;
}

// Numbers without a fraction count as integers as far as doubles are exact.
bool read(const Value& value, std::int64_t& to) {
  if (copy(value.if_integer(), to))
    return true;
  constexpr double largest = 9e15; // integers beyond are not exact in a double
  double number = 0;
  if (!read(value, number) || std::trunc(number) != number ||
      std::abs(number) > largest)
    return false;
  to = static_cast<std::int64_t>(number);
  return true;
}

bool read(const Value& value, bool& to) {
  return copy(value.if_boolean(), to);
}

bool read(const Value& value, List& to) {
  return copy(value.if_list(), to);
}

bool read(const Value& value, Map& to) {
  return copy(value.if_map(), to);
}

bool read(const Value& value, Binary& to) {
  return copy(value.if_binary(), to);
}

bool read(const Value& value, ResultSet& to) {
  return copy(value.if_result(), to);
}

// Unknown means that the parameter is missing.
bool read(const Value& value, Value& to) {
  to = value;
  return !value.is_unknown();
}

} // namespace parlour
