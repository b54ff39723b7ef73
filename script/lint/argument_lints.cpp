// odd-argument: a literal argument that the function does not take the way it
// looks, such as a pattern of another language.
//
//   format('%s of %s', a, b)      write '{} of {}'
//   date('dd.MM.yyyy')            write '%d.%m.%Y'
//   sort(list, 'desc')            did you mean 'descending'?
//   matches(text, '[0-9')         no regular expression
//   type(x) == 'str'              no such type
//
// Mistakes that are certain are errors of the compiler (literal_arguments.hpp).
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include <re2/re2.h>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

constexpr auto npos = std::string::npos;

// The literal string at this position; null if it is missing or computed.
const std::string* text_argument(const Node& call, std::size_t number) {
  if (number >= call.children.size() ||
      call.children[number]->kind != NodeKind::string)
    return nullptr;
  return &call.children[number]->text;
}

// The number of values that a pattern of format() takes.
std::size_t placeholders(std::string_view pattern) {
  std::size_t count = 0;
  for (std::size_t at = 0; at + 1 < pattern.size(); ++at) {
    const auto two = pattern.substr(at, 2);
    const bool begins = two == "{}" || two == "{:";
    count += begins;
    at += begins || two == "{{" || two == "}}";
  }
  return count;
}

std::string number_of(std::size_t count, const char* what) {
  return (count == 0 ? "no" : std::to_string(count)) + std::string(" ") + what +
         (count == 1 ? "" : "s");
}

// Replaces the placeholders of other languages, such as "{0}", "{name}" and
// "%s", by {}.
std::string with_placeholders(std::string pattern) {
  static const RE2 foreign(R"(\{\w+(?::[^{}]*)?\}|%[-+ 0-9.]*[sdifxgeu])");
  RE2::GlobalReplace(&pattern, foreign, "{}");
  return pattern;
}

// A pattern whose number of places differs from the number of values.
std::string odd_format(const Node& call) {
  const auto* pattern = text_argument(call, 0);
  if (!pattern)
    return {};
  const auto taken = placeholders(*pattern);
  const auto given = call.children.size() - 1;
  if (taken == given)
    return {};
  if (const auto meant = with_placeholders(*pattern);
      meant != *pattern && placeholders(meant) == given)
    return "format() has {} where a value goes, in their order: " +
           quoted_text(meant);
  return "the pattern takes " + number_of(taken, "value") + " ({}), and " +
         number_of(given, "value") + " follow" + (given == 1 ? "s" : "");
}

// Letters that stand for parts of a date in patterns of other languages, with
// their signs in strftime. Longer ones come before their prefixes.
constexpr std::array<std::pair<const char*, const char*>, 17> letters{{
    {"YYYY", "%Y"},
    {"yyyy", "%Y"},
    {"EEEE", "%A"},
    {"dddd", "%A"},
    {"MMMM", "%B"},
    {"MMM", "%b"},
    {"EEE", "%a"},
    {"ddd", "%a"},
    {"YY", "%y"},
    {"yy", "%y"},
    {"MM", "%m"},
    {"DD", "%d"},
    {"dd", "%d"},
    {"HH", "%H"},
    {"hh", "%I"},
    {"mm", "%M"},
    {"ss", "%S"},
}};

// Translates letter by letter; everything unknown is kept.
std::string as_strftime(std::string_view pattern) {
  std::string meant;
  while (!pattern.empty()) {
    const auto* found =
        std::find_if(letters.begin(), letters.end(), [&](const auto& one) {
          return pattern.starts_with(one.first);
        });
    if (found == letters.end())
      meant += pattern[0];
    else
      meant += found->second;
    pattern.remove_prefix(
        found == letters.end() ? 1 : std::string_view(found->first).size());
  }
  return meant;
}

// A pattern of date() or time() without any sign of strftime.
std::string odd_time(const Node& call) {
  const auto* pattern = text_argument(call, 0);
  if (!pattern || pattern->empty() || pattern->find('%') != npos)
    return {};
  const auto meant = as_strftime(*pattern);
  return quoted_text(*pattern) +
         " is given back as it stands; a pattern has the signs of strftime: " +
         (meant == *pattern ? call.text == "date" ? "'%d.%m.%Y'" : "'%H:%M'"
                            : quoted_text(meant));
}

// A word that is not one of the words a function knows.
std::string odd_word(const Node& call, std::size_t number,
                     const std::vector<std::string>& words) {
  const auto* word = text_argument(call, number);
  if (!word || std::find(words.begin(), words.end(), *word) != words.end())
    return {};
  auto hint = did_you_mean(*word, words);
  return call.text + "() knows no " + quoted_text(*word) +
         (hint.empty() ? "; it knows " + alternatives(words) : hint);
}

// Compiled by the same library that runs it.
std::string odd_regex(const Node& call) {
  const auto* pattern = text_argument(call, 1);
  if (!pattern)
    return {};
  const RE2 regex(*pattern, RE2::Quiet);
  return regex.ok() ? std::string()
                    : quoted_text(*pattern) +
                          " is no regular expression: " + regex.error();
}

// The functions whose literal arguments can be judged.
std::string odd_argument(const Node& call) {
  if (call.text == "format")
    return odd_format(call);
  if (call.text == "date" || call.text == "time")
    return odd_time(call);
  if (call.text == "sort")
    return odd_word(call, 1, {"ascending", "descending"});
  if (call.text == "matches" || call.text == "capture")
    return odd_regex(call);
  return {};
}

// Explains type(x) == 'str', a comparison with a word that is not a type.
std::string odd_type(const Node& comparison) {
  static const std::vector<std::string> types{
      "unknown", "boolean", "integer", "number", "string",
      "list",    "map",     "result",  "binary", "error"};
  const auto& [call, word] =
      std::tie(comparison.children[0], comparison.children[1]);
  if (comparison.operation > Operator::unequal ||
      call->kind != NodeKind::call || call->text != "type" ||
      word->kind != NodeKind::string ||
      std::find(types.begin(), types.end(), word->text) != types.end())
    return {};
  return "no type is called " + quoted_text(word->text) + "; there are " +
         alternatives(types);
}

// Explains <object class="array" size="-1">.
void lint_size(const Element& element, Findings& findings) {
  const auto* size = element.is("object") ? element.attribute("size") : nullptr;
  const auto parsed = parse_expression(size ? size->value : "");
  if (parsed.node &&
      (parsed.node->kind == NodeKind::number ||
       parsed.node->kind == NodeKind::string ||
       (parsed.node->kind == NodeKind::integer && parsed.node->integer < 0)))
    warn(findings, "odd-argument", size->value_position,
         "the size of an array is a whole number from 0 on, not " +
             size->value);
}

} // namespace

void lint_arguments(const LintContext& context, Findings& findings) {
  const auto report = [&](const Node& node, const Source& source,
                          std::string message) {
    if (!message.empty())
      warn(findings, "odd-argument", source.spot(node.offset),
           std::move(message));
  };
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    lint_size(element, findings);
    visit_nodes(element, rule, [&](const Node& whole, const Source& source) {
      visit_below(whole, [&](const Node& node) {
        if (node.kind == NodeKind::call &&
            !context.program.functions.count(node.text))
          report(node, source, odd_argument(node));
        else if (node.kind == NodeKind::binary)
          report(node, source, odd_type(node));
      });
    });
  });
}

} // namespace parlour::script::lint
