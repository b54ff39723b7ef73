#include "script/compiler/code/expressions/literal_arguments.hpp"

#include "script/source/findings.hpp"
#include "script/spoken/format_pattern.hpp"
#include "script/spoken/spoken.hpp"

namespace parlour::script {

namespace {

// The literal string at this position; null if it is missing or computed.
const std::string* literal(const Node& call, std::size_t index) {
  const bool there = index < call.children.size() &&
                     call.children[index]->kind == NodeKind::string;
  return there ? &call.children[index]->text : nullptr;
}

std::string number_of(std::size_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// More places than values are a mistake; more values than places only a warning
// (odd-argument), as the rest is ignored.
std::optional<WrongArgument> wrong_pattern(const Node& call) {
  const auto* text = literal(call, 0);
  if (!text)
    return {};
  const auto pattern = parse_format(*text);
  if (!pattern.error.empty())
    return WrongArgument{0, pattern.error};
  const auto values = call.children.size() - 1;
  if (pattern.places > values)
    return WrongArgument{0, "the pattern has " +
                                number_of(pattern.places, "place") + ", but " +
                                number_of(values, "value") +
                                (values == 1 ? " follows" : " follow")};
  return {};
}

// A misspelt kind would silently print the value as it is.
std::optional<WrongArgument> wrong_kind(const Node& call, std::size_t index) {
  const auto* kind = literal(call, index);
  if (!kind || is_spoken_kind(*kind))
    return {};
  return WrongArgument{index, "nothing is spoken as '" + *kind + "'" +
                                  did_you_mean(*kind, spoken_kinds())};
}

} // namespace

std::optional<WrongArgument> wrong_argument(const Node& call) {
  if (call.text == "format")
    return wrong_pattern(call);
  if (call.text == "spoken")
    return wrong_kind(call, 1);
  return call.text == "list" ? wrong_kind(call, 2) : std::nullopt;
}

} // namespace parlour::script
