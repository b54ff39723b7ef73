#include "adapters/mqtt/discovery/value_template.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "runtime/base/value.hpp"

namespace parlour::adapters::mqtt {

namespace {

constexpr std::array known_filters{"float", "int",    "round",   "lower",
                                   "upper", "string", "default", "is_defined"};

bool is_known_filter(const std::string& name) {
  return std::ranges::find(known_filters, name) != known_filters.end();
}

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return std::string(
      text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

bool is_name_part(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

// A boolean is 1 or 0, as templates count it.
std::optional<double> number_of(const Value& value) {
  if (const auto* truth = value.if_boolean())
    return *truth ? 1 : 0;
  const auto number = value.if_string() ? parse_number(value.text()) : value;
  if (!number.if_integer() && !number.if_number())
    return {};
  return number.number_or(0);
}

double rounded(double number, const std::optional<Value>& digits) {
  const auto wanted = digits ? number_of(*digits).value_or(0) : 0;
  const auto scale = std::pow(10.0, std::clamp(wanted, 0.0, 9.0));
  return std::round(number * scale) / scale;
}

// What int makes of a number; what does not fit stays as it is.
Value whole(double number) {
  constexpr double limit = 9e15;
  if (!(std::abs(number) < limit))
    return number;
  return static_cast<std::int64_t>(number);
}

template <class Change>
Value each_letter(const Value& value, Change change) {
  auto text = text_of(value);
  for (auto& letter : text)
    letter = static_cast<char>(change(static_cast<unsigned char>(letter)));
  return text;
}

} // namespace

// Reads one template; the first mistake ends it.
//
// It knows the part of Jinja that devices use: places in the JSON and a few
// filters. Statements such as {% if %} make a template unsupported; it is not
// guessed what they mean.
class TemplateReader {
public:
  explicit TemplateReader(std::string_view text) : text_(text) {}

  Expected<ValueTemplate> read() {
    ValueTemplate made;
    made.pieces_.clear();
    while (at_ < text_.size() && !is_wrong_) {
      const auto open = text_.find("{{", at_);
      const auto plain = text_.substr(at_, open - at_);
      if (plain.find("{%") != std::string_view::npos ||
          plain.find("{#") != std::string_view::npos)
        is_wrong_ = true;
      if (!plain.empty())
        made.pieces_.emplace_back(std::string(plain));
      if (open == std::string_view::npos)
        break;
      at_ = open + 2;
      made.pieces_.emplace_back(expression());
    }
    if (is_wrong_)
      return fail(ErrorKind::settings,
                  "the template '" + std::string(text_) +
                      "' is not supported; what is supported has the form "
                      "'{{ value_json.name }}'");
    return made;
  }

private:
  ValueTemplate::Expression expression() {
    ValueTemplate::Expression made;
    const auto root = name();
    made.is_json = root == "value_json";
    if (!made.is_json && root != "value")
      is_wrong_ = true;
    while (!is_wrong_ && (next_is('.') || next_is('[')))
      made.path.push_back(step());
    while (!is_wrong_ && take('|'))
      made.filters.push_back(filter());
    if (!take('}') || !take('}'))
      is_wrong_ = true;
    return made;
  }

  // ".name", "['name']" or "[0]".
  ValueTemplate::Step step() {
    if (take('.'))
      return name();
    take('[');
    const auto key = literal();
    const auto position = key.if_integer() ? *key.if_integer() : -1;
    if (!take(']') || (!key.if_string() && position < 0)) {
      is_wrong_ = true;
      return {};
    }
    if (key.if_string())
      return key.text();
    return static_cast<std::size_t>(position);
  }

  // "| round(1)", "| default('off')", "| lower".
  ValueTemplate::Filter filter() {
    ValueTemplate::Filter made{name(), {}};
    if (!is_known_filter(made.name))
      is_wrong_ = true;
    if (take('(') && !take(')')) {
      made.argument = literal();
      if (!take(')'))
        is_wrong_ = true;
    }
    return made;
  }

  std::string name() {
    skip_blanks();
    const auto start = at_;
    while (at_ < text_.size() && is_name_part(text_[at_]))
      ++at_;
    if (start == at_)
      is_wrong_ = true;
    return std::string(text_.substr(start, at_ - start));
  }

  // A number, or a text in single or double quotation marks.
  Value literal() {
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    if (quote != '\'' && quote != '"') {
      const auto end = std::min(text_.find_first_of("])", at_), text_.size());
      auto number = parse_number(text_.substr(at_, end - at_));
      is_wrong_ |= number.is_unknown();
      at_ = end;
      return number;
    }
    const auto end = text_.find(quote, at_ + 1);
    if (end == std::string_view::npos) {
      is_wrong_ = true;
      return {};
    }
    const auto start = at_ + 1;
    at_ = end + 1;
    return text_.substr(start, end - start);
  }

  void skip_blanks() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
  }
  bool next_is(char letter) {
    skip_blanks();
    return at_ < text_.size() && text_[at_] == letter;
  }
  bool take(char letter) {
    if (!next_is(letter))
      return false;
    ++at_;
    return true;
  }

  const std::string_view text_;
  std::size_t at_ = 0;
  bool is_wrong_ = false;
};

ValueTemplate::ValueTemplate() : pieces_{Expression{}} {}

Expected<ValueTemplate> ValueTemplate::parse(std::string_view text) {
  return TemplateReader(text).read();
}

// Nothing if a part of it is nothing: a message that does not mention the value
// says nothing about it.
std::optional<std::string> ValueTemplate::apply(const Payload& payload) const {
  std::string made;
  for (const auto& piece : pieces_)
    if (const auto* plain = std::get_if<std::string>(&piece))
      made += *plain;
    else if (const auto part = evaluate(std::get<Expression>(piece), payload))
      made += *part;
    else
      return {};
  return trimmed(made);
}

std::optional<std::string> ValueTemplate::evaluate(const Expression& expression,
                                                   const Payload& payload) {
  auto value = find(expression, payload);
  for (const auto& one : expression.filters)
    if (!filter(value, one))
      return {};
  return value ? std::optional(text_of(*value)) : std::nullopt;
}

// A step that leads nowhere is nothing, not an error: many devices share a
// topic.
std::optional<Value> ValueTemplate::find(const Expression& expression,
                                         const Payload& payload) {
  if (!expression.is_json)
    return expression.path.empty() ? std::optional<Value>(payload.text())
                                   : std::nullopt;
  const auto* at = payload.json();
  for (const auto& step : expression.path) {
    if (!at)
      return {};
    if (const auto* position = std::get_if<std::size_t>(&step)) {
      const auto* list = at->if_list();
      at = list && *position < list->size() ? &(*list)[*position] : nullptr;
    } else {
      const auto* map = at->if_map();
      at = map ? map->find(std::get<std::string>(step)) : nullptr;
    }
  }
  return at ? std::optional(*at) : std::nullopt;
}

// False if the filter makes nothing of the value.
bool ValueTemplate::filter(std::optional<Value>& value, const Filter& filter) {
  const auto& [name, argument] = filter;
  if (name == "default") {
    if (!value)
      value = argument.value_or("");
    return true;
  }
  if (!value)
    return false;
  if (name == "lower")
    value = each_letter(*value, [](int c) { return std::tolower(c); });
  else if (name == "upper")
    value = each_letter(*value, [](int c) { return std::toupper(c); });
  else if (name == "string")
    value = Value(text_of(*value));
  if (name != "float" && name != "int" && name != "round")
    return true;
  const auto number = number_of(*value);
  if (!number && name != "round" && argument)
    value = *argument;
  else if (!number)
    return false;
  else if (name == "float")
    value = *number;
  else
    value = name == "int" ? whole(*number) : Value(rounded(*number, argument));
  return true;
}

} // namespace parlour::adapters::mqtt
