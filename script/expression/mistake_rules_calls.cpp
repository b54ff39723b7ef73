// Rules about calls: methods of objects (text.length()), functions of libraries
// (Math.max), and filters of templates (name | upper).
#include <algorithm>
#include <iterator>

#include "script/expression/builtins.hpp"
#include "script/expression/common_mistakes.hpp"
#include "script/expression/mistake_rules.hpp"
#include "script/source/findings.hpp"

namespace parlour::script::mistake_rules {

namespace {

// A function that another language reaches through an object, and its name
// here.
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
// Objects whose functions are built-in functions here, under the same name.
constexpr std::string_view libraries[] = {"Math",   "math",  "Object", "Number",
                                          "String", "Array", "random"};

// The built-in function for a call through a library object; empty if the
// object is an ordinary operand.
std::string of_library(std::string_view object, std::string_view name) {
  for (const auto& [whose, written, meant] : methods)
    if (whose == object && written == name)
      return string_of(meant);
  const bool is_library = std::find(std::begin(libraries), std::end(libraries),
                                    object) != std::end(libraries);
  return is_library && is_builtin(name) ? string_of(name) : std::string();
}

// The built-in function that is meant by this name, here or in another
// language; empty if there is none.
std::string function_called(std::string_view name) {
  const auto* mistake = find_mistake(MistakePlace::function, name);
  if (mistake)
    return string_of(mistake->meant);
  const auto right = same_but_case(name, builtin_names());
  return is_builtin(name) ? string_of(name) : right;
}

// A call object.name(arguments), as views into the source.
struct MethodCall {
  std::string_view object;
  std::string_view name;
  std::vector<std::string_view> arguments;

  // The call as a function of the object: name(object, arguments).
  std::string with(std::string_view function) const {
    auto call = string_of(function) + "(" + string_of(object);
    for (const auto argument : arguments)
      call += ", " + string_of(argument);
    return call + ")";
  }
};

// Whether the operand is a string literal.
bool is_text(std::string_view operand) {
  return operand.front() == '\'' || operand.front() == '"';
}

// Fills a pattern of common_mistakes.def: #0 is the object, #1 … are the
// arguments. Within quotes only a number can be filled in; for anything else
// the result is empty.
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

// The row for this number of arguments, else the row for any number.
const Mistake* method_mistake(const MethodCall& call) {
  const auto name = string_of(call.name);
  const auto count = std::to_string(call.arguments.size());
  const auto* of_count = find_mistake(MistakePlace::method, name + "/" + count);
  return of_count ? of_count : find_mistake(MistakePlace::method, name);
}

// Whether the built-in function takes this number of arguments.
bool takes(const std::string& function, std::size_t arguments) {
  const auto index = builtin_index(function);
  return index && arguments >= builtin(*index).minimum &&
         arguments <= builtin(*index).maximum;
}

// How the call is written here; empty if no function does this.
std::string call_meant(const MethodCall& call) {
  // Python joins the other way round: ', '.join(list).
  if (call.name == "join" && is_text(call.object) && call.arguments.size() == 1)
    return filled("join(#1, #0)", call);
  if (const auto* mistake = method_mistake(call))
    return filled(mistake->meant, call);
  const auto function = function_called(call.name);
  return takes(function, call.arguments.size() + 1) ? call.with(function) : "";
}

// The explanation for a method that has no counterpart, from the most helpful
// to the least: advice of the table, a function of that name, a similar name.
std::string no_function(const MethodCall& call) {
  const auto none = "there is no function '" + string_of(call.name) + "' here";
  const auto* mistake = find_mistake(MistakePlace::method, call.name);
  if (!mistake)
    mistake = find_mistake(MistakePlace::function, call.name);
  if (mistake && !mistake->sentence.empty())
    return none + "; " + string_of(mistake->sentence);
  if (const auto function = function_called(call.name); !function.empty())
    return "a function stands before what it works on: " + function + "(" +
           string_of(call.object) + ", …)";
  const auto near = did_you_mean(call.name, builtin_names());
  return none + (near.empty()
                     ? "; one of your own is called " + call.with(call.name)
                     : near + " A function stands before what it "
                              "works on");
}

// Whether the text is a single call, which decides the wording of the advice.
bool is_call(const std::string& expression) {
  const auto parsed = parse_expression(expression);
  return parsed.node && parsed.node->kind == NodeKind::call;
}

// Explains a call through a library object: only its beginning is replaced.
Found called_of_library(const Scene& scene, std::size_t begin,
                        const MethodCall& call) {
  const auto meant = of_library(call.object, call.name);
  if (meant.empty())
    return {};
  return ExpressionMistake{begin, scene.at - begin,
                           "a function stands by itself here: " + meant + "(…)",
                           meant};
}

} // namespace

// Explains x.length(), list.add(y) and Math.max(x, y). The parser gave up at
// the bracket, since only a plain name can be called.
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
    return ExpressionMistake{name_at, call.name.size(), no_function(call)};
  ExpressionMistake mistake{
      begin, scene.at - begin,
      is_call(meant)
          ? "a function stands before what it works on: " + meant
          : "there is no '" + string_of(call.name) + "' here; write " + meant};
  if (close == npos)
    return mistake;
  mistake.length = close + 1 - begin;
  mistake.replacement = meant;
  return mistake;
}

// Explains name | upper, the filter of template languages.
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
  ExpressionMistake mistake{from, end - from,
                            "a function stands before what it works on: " +
                                name + "(" + string_of(object) + ")"};
  if (end == scene.text.size() || scene.text[end] != '(')
    mistake.replacement = name + "(" + string_of(object) + ")";
  return mistake;
}

} // namespace parlour::script::mistake_rules
