// Checks by kind. For names the message also says what the author may have
// meant, since a wrong name is often an expression or a list of parameters.

#include "script/xml/attribute_check.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include "runtime/base/clock.hpp"
#include "script/expression/expression.hpp"
#include "script/source/findings.hpp"
#include "script/source/source.hpp"

namespace parlour::script {

namespace {

// Bytes of characters beyond ASCII count as letters, so no tables are needed.
bool is_name_start(char letter) {
  return std::isalpha(static_cast<unsigned char>(letter)) || letter == '_' ||
         static_cast<unsigned char>(letter) >= 0x80;
}

bool is_name_part(char letter) {
  return is_name_start(letter) ||
         std::isdigit(static_cast<unsigned char>(letter));
}

// A value with `{expr}` is computed at run time and checked then.
bool is_right(AttributeKind kind, const std::string& value) {
  switch (kind) {
  case AttributeKind::name:
    return is_identifier(value);
  case AttributeKind::duration:
    return value.find('{') != std::string::npos ||
           parse_duration(value).has_value();
  case AttributeKind::boolean:
    return value == "true" || value == "false";
  case AttributeKind::integer:
    return parse_count(value).has_value();
  case AttributeKind::size:
    return parse_size(value).has_value();
  default:
    return true;
  }
}

// The beginning of each message: the attribute as it is written.
std::string shown(const ElementRule& element, const AttributeRule& rule,
                  const std::string& value) {
  return rule.name + "=\"" + value + "\" of <" + element.name + ">: expected ";
}

// The correction of <for each="x in list">; empty if the value has another
// form.
std::string loop_meant(const ElementRule& element, const std::string& value) {
  const auto in = value.find(" in ");
  if (!element.attribute("each") || in == std::string::npos)
    return {};
  return "; write each=\"" + collapsed(value.substr(0, in)) + "\" in=\"" +
         collapsed(value.substr(in + 4)) + "\"";
}

// The correction of <function name="f(a, b)">; empty if the value has another
// form.
std::string head_meant(const ElementRule& element, const AttributeRule& rule,
                       const std::string& value) {
  const auto open = value.find('(');
  if (open == std::string::npos)
    return {};
  auto meant =
      "; write " + rule.name + "=\"" + collapsed(value.substr(0, open)) + "\"";
  if (element.name != "function")
    return meant;
  const auto close = std::min(value.rfind(')'), value.size());
  std::string params;
  std::string word;
  for (auto i = open + 1; i <= close && close > open; ++i)
    if (i < close && is_name_part(value[i]))
      word += value[i];
    else if (!word.empty())
      params += "<param name=\"" + std::exchange(word, {}) + "\"/>";
  return params.empty() ? meant : meant + ", and inside of it " + params;
}

// The correction of a value that is not a name: the attributes that were meant,
// or a similar name; empty if there is none.
std::string name_meant(const ElementRule& element, const AttributeRule& rule,
                       const std::string& value) {
  const auto write = "; write " + rule.name + "=\"";
  if (auto meant = loop_meant(element, value); !meant.empty())
    return meant;
  if (auto meant = head_meant(element, rule, value); !meant.empty())
    return meant;
  if (const auto equals = value.find('=');
      equals != std::string::npos && element.attribute("expr"))
    return write + collapsed(value.substr(0, equals)) + "\" expr=\"" +
           collapsed(value.substr(equals + 1)) + "\"";
  std::string meant;
  for (const char letter : collapsed(value))
    if (is_name_part(letter))
      meant += letter;
    else if (letter == ' ' || letter == '-' || letter == '.')
      meant += '_';
  return is_identifier(meant) ? write + meant + "\"" : std::string();
}

} // namespace

// A choice lists its words; other kinds have a sentence in the table.
std::string wrong_value(const ElementRule& element, const AttributeRule& rule,
                        const std::string& value) {
  if (rule.kind == AttributeKind::choice) {
    const auto& words = rule.words;
    if (std::find(words.begin(), words.end(), value) != words.end())
      return {};
    return shown(element, rule, value) + alternatives(words) +
           did_you_mean(value, words);
  }
  if (is_right(rule.kind, value))
    return {};
  return shown(element, rule, value) + std::string(sentence_of(rule.kind)) +
         (rule.kind == AttributeKind::name ? name_meant(element, rule, value)
                                           : std::string());
}

bool is_identifier(std::string_view text) {
  return !text.empty() && is_name_start(text.front()) &&
         std::all_of(text.begin(), text.end(), is_name_part);
}

// Language rule 5.9 reserves names that begin with '_'.
std::string variable_fault(std::string_view name) {
  const auto quoted = "'" + std::string(name) + "'";
  if (name.starts_with('_'))
    return quoted + " begins with '_', as only the system's variables do";
  if (is_reserved(name) || name == "this")
    return quoted + " is a word of the language; a variable needs another name";
  return {};
}

// The limit of a terabyte keeps the product from overflowing.
std::optional<std::size_t> parse_size(std::string_view text) {
  std::size_t unit = 1;
  for (const auto& [suffix, shift] :
       {std::pair{"KB", 10}, std::pair{"MB", 20}, std::pair{"GB", 30}})
    if (text.ends_with(suffix)) {
      unit <<= shift;
      text.remove_suffix(2);
      break;
    }
  const auto count = parse_count(text);
  if (!count || *count > (std::size_t{1} << 40) / unit)
    return std::nullopt;
  return static_cast<std::size_t>(*count) * unit;
}

// Digits only: no sign, no blanks.
std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::uint64_t number = 0;
  const auto* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (text.empty() || result.ec != std::errc() || result.ptr != end)
    return std::nullopt;
  return number;
}

} // namespace parlour::script
