#include "adapters/http/rules/answer_reader.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <re2/re2.h>

#include "runtime/base/text/utf8.hpp"
#include "runtime/text/json_text.hpp"

namespace parlour::adapters::http {

namespace {

using Kind = TemplatePart::Kind;
using Unexpected = tl::unexpected<std::string>;
using Made = tl::expected<Answer, NoEvent>;
using Found = tl::expected<Value, std::string>;

// A text may be in another encoding; what is no UTF-8 becomes "?".
std::string readable(std::string text) {
  for (std::size_t from = 0; from < text.size();) {
    const auto wrong = find_invalid_utf8(std::string_view(text).substr(from));
    if (!wrong)
      break;
    text[from + *wrong] = '?';
    from += *wrong + 1;
  }
  return text;
}

// Values of a list are told with commas between them.
// "rain, sun, rain": for a text in which the values stand.
std::string spoken(const Value& value) {
  const auto* list = value.if_list();
  if (!list)
    return value.text();
  std::string text;
  for (const auto& one : *list)
    text += (text.empty() ? "" : ", ") + one.text();
  return text;
}

// One answer, read as far as the rules ask for it.
// The JSON is parsed when a rule first asks for it.
//
//   the first rule of which status, has, is and matches all apply -> its event
//   its parameters: {name} of the command, {/path} in the JSON, {0} a match
class Reader {
public:
  Reader(const std::vector<AnswerRule>& rules, const std::string& file,
         const std::string& subject, const HttpAnswer& answer,
         const List& parameters)
      : rules_(rules), file_(file), subject_(subject), answer_(answer),
        parameters_(parameters), text_(readable(answer.body)) {}

  Made read() {
    for (const auto& rule : rules_)
      if (applies(rule))
        return event_of(rule);
    return tl::make_unexpected(
        NoEvent{subject_ + " " + std::to_string(answer_.status) + ".", true});
  }

private:
  // {0} is the whole text where the rule has no expression.
  bool applies(const AnswerRule& rule) {
    const auto fits = [this](const auto& range) {
      return range.first <= answer_.status && answer_.status <= range.second;
    };
    if (!rule.statuses.empty() && !std::ranges::any_of(rule.statuses, fits))
      return false;
    if (rule.has && !has(*rule.has, rule.is))
      return false;
    groups_.assign(1, text_);
    return !rule.matches || match(*rule.matches);
  }

  // An answer that is no JSON has nothing, and is no mistake here: another rule
  // may fit it.
  bool has(const JsonPath& path, const std::optional<std::string>& wanted) {
    const auto& answer = json();
    const auto found = answer ? path.find(*answer) : std::nullopt;
    return found && !found->is_unknown() &&
           (!wanted || found->text() == *wanted);
  }

  // Keeps the match and its groups; one that took no part is empty.
  bool match(const re2::RE2& expression) {
    const auto count =
        static_cast<std::size_t>(expression.NumberOfCapturingGroups()) + 1;
    std::vector<re2::StringPiece> parts(count);
    if (!expression.Match(text_, 0, text_.size(), re2::RE2::UNANCHORED,
                          parts.data(), static_cast<int>(count)))
      return false;
    groups_.clear();
    for (const auto& part : parts)
      groups_.emplace_back(part.data() ? part.data() : "", part.size());
    return true;
  }

  // A value that the answer lacks is replaced by the rule's `else`; without one
  // the whole answer becomes no event.
  Made event_of(const AnswerRule& rule) {
    Answer event{rule.event.name, {}};
    for (const auto& param : rule.event.params) {
      auto value = value_of(param.value);
      const bool lacks = !value || value->is_unknown();
      if (lacks && param.otherwise)
        value = Value(*param.otherwise);
      if (!value)
        return tl::make_unexpected(NoEvent{subject_ + " " + value.error() +
                                           " (" + file_ + ":" +
                                           std::to_string(param.line) + ")."});
      event.params.push_back(std::move(*value));
    }
    return event;
  }

  // A part that stands alone keeps its type; others become one text.
  Found value_of(const TextTemplate& text) {
    if (const auto* part = text.single())
      return value_of(*part);
    std::string result;
    for (const auto& part : text.parts) {
      auto value = value_of(part);
      if (!value)
        return value;
      if (value->is_unknown() && part.kind == Kind::path)
        return Unexpected("without a value at " + part.path.text());
      if (!value->is_unknown())
        result += spoken(*value);
    }
    return Value(std::move(result));
  }

  Found value_of(const TemplatePart& part) {
    switch (part.kind) {
    case Kind::parameter:
      return part.number < parameters_.size() ? parameters_[part.number]
                                              : Value();
    case Kind::group:
      return part.number < groups_.size() ? Value(groups_[part.number])
                                          : Value();
    case Kind::path:
      return at(part.path);
    default:
      return Value(part.text);
    }
  }

  Found at(const JsonPath& path) {
    const auto& answer = json();
    if (!answer)
      return Unexpected(answer.error() == JsonFault::too_deep
                            ? "with JSON that is nested too deep"
                            : "with something that is no JSON");
    if (auto found = path.find(*answer))
      return std::move(*found);
    return Unexpected("without " + path.text() + ", which its rule needs");
  }

  // Read once, and only if a rule asks for it.
  const tl::expected<Value, JsonFault>& json() {
    if (!json_)
      json_ = read_json(answer_.body);
    return *json_;
  }

  const std::vector<AnswerRule>& rules_;
  const std::string& file_;
  const std::string& subject_;
  const HttpAnswer& answer_;
  const List& parameters_;
  const std::string text_;
  std::vector<std::string> groups_;
  std::optional<tl::expected<Value, JsonFault>> json_;
};

} // namespace

Made read_answer(const std::vector<AnswerRule>& rules, const std::string& file,
                 const std::string& subject, const HttpAnswer& answer,
                 const List& parameters) {
  return Reader(rules, file, subject, answer, parameters).read();
}

const SampleRule* find_sample(const CommandRule& command,
                              const List& parameters) {
  const SampleRule* usual = nullptr;
  for (const auto& sample : command.samples)
    if (!sample.whom)
      usual = usual ? usual : &sample;
    else if (std::ranges::any_of(parameters, [&](const Value& parameter) {
               return parameter.text() == *sample.whom;
             }))
      return &sample;
  return usual;
}

} // namespace parlour::adapters::http
