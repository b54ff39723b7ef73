// What is called: methods of other languages, and filters of templates.
#include <algorithm>
#include <iterator>

#include "script/expression/builtins.hpp"
#include "script/expression/slip_rules.hpp"
#include "script/expression/slips.hpp"
#include "script/source/findings.hpp"

namespace parlour::script::slip_rules {

namespace {

// What other languages call by way of an object of their own.
struct Method {
  std::string_view object;
  std::string_view name;
  std::string_view meant;
};
constexpr Method methods[] = {
    {"JSON", "parse", "fromjson"}, {"JSON", "stringify", "tojson"},
    {"json", "loads", "fromjson"}, {"json", "dumps", "tojson"},
    {"Date", "now", "now"},        {"date", "today", "date"},
    {"datetime", "now", "now"},
};
constexpr std::string_view libraries[] = {"Math",   "math",  "Object", "Number",
                                          "String", "Array", "random"};

// "" where the object is what the function works on.
std::string of_library(std::string_view object, std::string_view name) {
  for (const auto& [whose, written, meant] : methods)
    if (whose == object && written == name)
      return string_of(meant);
  const bool is_library = std::find(std::begin(libraries), std::end(libraries),
                                    object) != std::end(libraries);
  return is_library && is_builtin(name) ? string_of(name) : std::string();
}

// The built-in function that is called so elsewhere, or here; else empty.
std::string function_called(std::string_view name) {
  const auto* slip = find_slip(SlipPlace::function, name);
  if (slip)
    return string_of(slip->meant);
  const auto right = same_but_case(name, builtin_names());
  return is_builtin(name) ? string_of(name) : right;
}

struct MethodCall {
  std::string_view object;
  std::string_view name;
  std::vector<std::string_view> arguments;

  std::string with(std::string_view function) const {
    auto call = string_of(function) + "(" + string_of(object);
    for (const auto argument : arguments)
      call += ", " + string_of(argument);
    return call + ")";
  }
};

bool is_text(std::string_view operand) {
  return operand.front() == '\'' || operand.front() == '"';
}

// #0 is the object, #1 and so on the arguments; empty where one would stand in
// a text, and is no number.
std::string filled(std::string_view pattern, const MethodCall& call) {
  std::string result;
  bool quoted = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    quoted ^= pattern[i] == '\'';
    if (pattern[i] != '#') {
      result += pattern[i];
      continue;
    }
    const auto which = static_cast<std::size_t>(pattern[++i] - '0');
    const auto part = which == 0 ? call.object : call.arguments[which - 1];
    if (quoted && !std::all_of(part.begin(), part.end(), is_digit))
      return {};
    result += part;
  }
  return result;
}

// Of these arguments in particular, or of any.
const Slip* method_slip(const MethodCall& call) {
  const auto name = string_of(call.name);
  const auto count = std::to_string(call.arguments.size());
  const auto* of_count = find_slip(SlipPlace::method, name + "/" + count);
  return of_count ? of_count : find_slip(SlipPlace::method, name);
}

bool takes(const std::string& function, std::size_t arguments) {
  const auto index = builtin_index(function);
  return index && arguments >= builtin(*index).minimum &&
         arguments <= builtin(*index).maximum;
}

// What the call is written like here; empty: no function does it.
std::string call_meant(const MethodCall& call) {
  if (call.name == "join" && is_text(call.object) && call.arguments.size() == 1)
    return filled("join(#1, #0)", call);
  if (const auto* slip = method_slip(call))
    return filled(slip->meant, call);
  const auto function = function_called(call.name);
  return takes(function, call.arguments.size() + 1) ? call.with(function) : "";
}

std::string no_function(const MethodCall& call) {
  const auto none = "there is no function '" + string_of(call.name) + "' here";
  const auto* slip = find_slip(SlipPlace::method, call.name);
  if (!slip)
    slip = find_slip(SlipPlace::function, call.name);
  if (slip && !slip->sentence.empty())
    return none + "; " + string_of(slip->sentence);
  if (const auto function = function_called(call.name); !function.empty())
    return "a function stands before what it works on: " + function + "(" +
           string_of(call.object) + ", …)";
  const auto near = did_you_mean(call.name, builtin_names());
  return none + (near.empty()
                     ? "; one of your own is called " + call.with(call.name)
                     : near + " A function stands before what it "
                              "works on");
}

bool is_call(const std::string& expression) {
  const auto parsed = parse_expression(expression);
  return parsed.node && parsed.node->kind == NodeKind::call;
}

// The bytes of a library's call, or nothing.
Found called_of_library(const Scene& scene, std::size_t begin,
                        const MethodCall& call) {
  const auto meant = of_library(call.object, call.name);
  if (meant.empty())
    return {};
  return ExpressionSlip{begin, scene.at - begin,
                        "a function stands by itself here: " + meant + "(…)",
                        meant};
}

} // namespace

// x.length(), list.add(y) and Math.max(x, y).
Found method(const Scene& scene) {
  if (!scene.rest().starts_with('(') || scene.at == 0)
    return {};
  const auto name_at = word_begin(scene.text, scene.at);
  if (name_at == 0 || scene.text[name_at - 1] != '.')
    return {};
  const auto begin = operand_begin(scene.text, name_at - 1);
  if (begin == name_at - 1)
    return {};
  MethodCall call{scene.text.substr(begin, name_at - 1 - begin),
                  scene.text.substr(name_at, scene.at - name_at),
                  {}};
  if (auto found = called_of_library(scene, begin, call))
    return found;
  const auto close = closing_of(scene.text, scene.at);
  const auto inside = std::min(close, scene.text.size()) - scene.at - 1;
  call.arguments = split_arguments(scene.text.substr(scene.at + 1, inside));
  const auto meant = call_meant(call);
  if (meant.empty())
    return ExpressionSlip{name_at, call.name.size(), no_function(call)};
  ExpressionSlip slip{
      begin, scene.at - begin,
      is_call(meant)
          ? "a function stands before what it works on: " + meant
          : "there is no '" + string_of(call.name) + "' here; write " + meant};
  if (close == npos)
    return slip;
  slip.length = close + 1 - begin;
  slip.replacement = meant;
  return slip;
}

// name | upper, as templates have it.
Found filter(const Scene& scene) {
  if (!scene.rest().starts_with('|') || scene.rest().starts_with("||"))
    return {};
  const auto begin = scene.text.find_first_not_of(blanks, scene.at + 1);
  if (begin == npos)
    return {};
  const auto end = word_end(scene.text, begin);
  const auto name = function_called(scene.text.substr(begin, end - begin));
  const auto before = scene.before();
  const auto object = before.substr(path_begin(before, before.size()));
  if (!is_builtin(name) || object.empty())
    return {};
  const auto from = static_cast<std::size_t>(object.data() - scene.text.data());
  ExpressionSlip slip{from, end - from,
                      "a function stands before what it works on: " + name +
                          "(" + string_of(object) + ")"};
  if (end == scene.text.size() || scene.text[end] != '(')
    slip.replacement = name + "(" + string_of(object) + ")";
  return slip;
}

} // namespace parlour::script::slip_rules
