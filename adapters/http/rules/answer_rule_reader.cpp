#include "adapters/http/rules/answer_rule_reader.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>

#include <pugixml.hpp>
#include <re2/re2.h>

#include "runtime/text/words.hpp"

namespace parlour::adapters::http {

namespace {

// The memory that one expression may take.
// RE2 refuses an expression that would need more; matching takes linear time in
// any case.
constexpr std::int64_t max_expression = 1 << 20;

std::optional<int> read_number(std::string_view text) {
  int number = 0;
  const auto read =
      std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size())
    return std::nullopt;
  return number;
}

// "200", "2xx", "400-404".
// Both ends belong to the range.
std::optional<std::pair<int, int>> read_statuses(const std::string& text) {
  const auto dash = text.find('-');
  auto from = read_number(text.substr(0, dash));
  auto to =
      dash == std::string::npos ? from : read_number(text.substr(dash + 1));
  if (text.size() == 3 && text.ends_with("xx")) {
    from = read_number(text.substr(0, 1));
    if (from) {
      *from *= 100;
      to = *from + 99;
    }
  }
  if (!from || !to || *from < 100 || *to > 599 || *from > *to)
    return std::nullopt;
  return std::pair(*from, *to);
}

} // namespace

// An <otherwise> is a rule without statuses, so it applies always.
void AnswerRuleReader::read(const pugi::xml_node& node,
                            const std::vector<std::string>& parameters,
                            std::vector<AnswerRule>& answers) {
  AnswerRule rule;
  rule.line = xml_.line_of(node);
  if (!answers.empty() && answers.back().statuses.empty())
    xml_.error(node, "behind <otherwise> nothing can apply");
  if (std::string_view(node.name()) == "on")
    read_conditions(node, rule);
  else
    xml_.check_attributes(node, {});
  TemplateNames names{parameters, false};
  if (rule.matches)
    names.groups =
        static_cast<std::size_t>(rule.matches->NumberOfCapturingGroups());
  const auto event = node.child("event");
  const auto elements =
      std::ranges::count_if(node.children(), [](const pugi::xml_node& one) {
        return one.type() == pugi::node_element;
      });
  if (!event || elements != 1)
    return xml_.error(node, "<" + std::string(node.name()) +
                                "> has one <event>, and nothing else");
  read_event(event, rule.event, names);
  answers.push_back(std::move(rule));
}

// Without a status every success counts.
void AnswerRuleReader::read_conditions(const pugi::xml_node& node,
                                       AnswerRule& rule) {
  if (of_ == Of::webhook)
    xml_.check_attributes(node, {}, {"has", "is", "matches"});
  else
    xml_.check_attributes(node, {}, {"status", "has", "is", "matches"});
  for (const auto& word : split_words(
           node.attribute("status") ? node.attribute("status").value() : "2xx"))
    if (const auto range = read_statuses(word))
      rule.statuses.push_back(*range);
    else
      xml_.error(node, "'" + word +
                           "' is no status such as 200, 2xx or "
                           "400-404");
  if (rule.statuses.empty())
    rule.statuses.emplace_back(100, 599);
  if (const std::string_view has = node.attribute("has").value();
      has.starts_with('/'))
    rule.has.emplace(has);
  else if (node.attribute("has"))
    xml_.error(node,
               "has=\"…\" is a place in the answer and begins with \"/\"");
  if (const auto is = node.attribute("is"))
    rule.is = is.value();
  if (rule.is && !rule.has)
    xml_.error(node, "is=\"…\" needs has=\"/…\", the place that is compared");
  if (const auto matches = node.attribute("matches")) {
    re2::RE2::Options options;
    options.set_log_errors(false);
    options.set_max_mem(max_expression);
    rule.matches = std::make_shared<const re2::RE2>(matches.value(), options);
    if (!rule.matches->ok())
      xml_.error(node, "matches=\"…\": " + rule.matches->error());
  }
}

// The place of each parameter is kept, so that a failure at run time can name
// its line.
void AnswerRuleReader::read_event(const pugi::xml_node& node, EventRule& event,
                                  const TemplateNames& names) {
  if (!xml_.check_attributes(node, {"name"}))
    return;
  event.name = node.attribute("name").value();
  for (const auto child : node.children()) {
    if (child.type() != pugi::node_element)
      continue;
    if (std::string_view(child.name()) != "param") {
      xml_.unknown(child, "<param>");
      continue;
    }
    xml_.check_attributes(child, {}, {"value", "else"});
    std::vector<std::string> none;
    auto value = read_template(child.attribute("value").value(), names, none);
    if (!value)
      xml_.error(child, value.error());
    ParamRule param{value.value_or(TextTemplate()), {}, xml_.line_of(child)};
    if (const auto otherwise = child.attribute("else"))
      param.otherwise = otherwise.value();
    event.params.push_back(std::move(param));
  }
  check_event(node, event);
}

// An event of the role has the role's parameters and ends a request.
void AnswerRuleReader::check_event(const pugi::xml_node& node,
                                   const EventRule& event) {
  const auto* known = role_ ? role_->event(event.name) : nullptr;
  if (known && known->reply == Reply::none && of_ == Of::command)
    return xml_.error(node, event.name +
                                " ends no request, so that whoever has asked "
                                "would wait in vain");
  if (!known && event.name != "Failed")
    return;
  const std::string parameters = known ? known->parameters : "reason";
  const auto all = read_parameters(parameters);
  const auto needed = static_cast<std::size_t>(std::ranges::count_if(
      all, [](const Parameter& one) { return !one.optional && !one.repeats; }));
  const bool repeats = !all.empty() && all.back().repeats;
  const auto given = event.params.size();
  if (given < needed || (given > all.size() && !repeats))
    xml_.error(node,
               "the event " + event.name + " has " +
                   (all.empty() ? "no parameters"
                                : "the parameters \"" + parameters + "\"") +
                   ", and here are " + std::to_string(given));
}

// Its text is taken as it stands, without the blanks around it.
void AnswerRuleReader::read_sample(const pugi::xml_node& node,
                                   std::vector<SampleRule>& samples) {
  if (of_ == Of::webhook)
    xml_.check_attributes(node, {});
  else
    xml_.check_attributes(node, {}, {"status", "for"});
  SampleRule sample;
  const auto status = node.attribute("status");
  const auto number = status ? read_number(status.value()) : 200;
  if (!number || *number < 100 || *number > 599)
    return xml_.error(node, "'" + std::string(status.value()) +
                                "' is no status such as 200");
  sample.answer = {*number, text_of(node)};
  sample.line = xml_.line_of(node);
  if (const auto whom = node.attribute("for"))
    sample.whom = whom.value();
  samples.push_back(std::move(sample));
}

} // namespace parlour::adapters::http
