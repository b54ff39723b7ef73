#include "adapters/http/rules/rules_reader.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <pugixml.hpp>
#include <re2/re2.h>

#include "adapters/http/message/http_address.hpp"
#include "adapters/http/rules/answer_reader.hpp"
#include "adapters/http/rules/request_maker.hpp"
#include "adapters/http/rules/request_reader.hpp"
#include "runtime/text/json_text.hpp"
#include "runtime/text/words.hpp"

namespace parlour::adapters::http {

namespace {

// The memory that one expression may take.
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

// Reads one file.
class Reader {
public:
  Reader(std::string_view text, const std::string& file,
         const Environment& environment, std::string address)
      : text_(text), xml_(text, file), environment_(environment),
        address_(std::move(address)) {
    read_.rules.file = file;
  }

  tl::expected<ReadRules, std::vector<Error>> run() {
    pugi::xml_document document;
    const auto loaded = document.load_buffer(text_.data(), text_.size());
    if (!loaded)
      xml_.error(xml_.line_of(loaded.offset),
                 std::string("this is no XML: ") + loaded.description());
    else
      read_service(document.document_element());
    if (xml_.has_errors())
      return tl::make_unexpected(xml_.take_errors());
    return std::move(read_);
  }

private:
  void read_service(const pugi::xml_node& root);
  void read_command(const pugi::xml_node& node);
  void read_parameters_of(const pugi::xml_node& node, CommandRule& command);
  void read_child(const pugi::xml_node& node, CommandRule& command,
                  const std::vector<std::string>& parameters);
  void read_request(const pugi::xml_node& node, CommandRule& command,
                    Method method, const std::vector<std::string>& parameters);
  void read_answer_rule(const pugi::xml_node& node, CommandRule& command,
                        const std::vector<std::string>& parameters);
  void read_conditions(const pugi::xml_node& node, AnswerRule& rule);
  void read_event(const pugi::xml_node& node, EventRule& event,
                  const TemplateNames& names);
  void check_event(const pugi::xml_node& node, const EventRule& event);
  void read_sample(const pugi::xml_node& node, CommandRule& command);
  void check_command(const pugi::xml_node& node, const CommandRule& command);
  void check_request(const CommandRule& command, const List& parameters);
  void check_samples(const CommandRule& command, const List& parameters);

  std::string_view text_;
  RulesXml xml_;
  const Environment& environment_;
  std::string address_;
  const Role* role_ = nullptr;
  ReadRules read_;
  std::uint32_t request_line_ = 0; // of the command that is being read
};

void Reader::read_service(const pugi::xml_node& root) {
  if (std::string_view(root.name()) != "service")
    return xml_.error(root, "the file's element is <service>, not <" +
                                std::string(root.name()) + ">");
  xml_.check_attributes(root, {}, {"role", "address"});
  read_.rules.role = root.attribute("role").value();
  role_ = find_role(read_.rules.role);
  if (root.attribute("role") && (!role_ || role_->reserved))
    xml_.error(root, "there is no role '" + read_.rules.role +
                         "'; 'parlour plugin roles' lists them, and a service "
                         "of its own kind has none");
  if (address_.empty())
    address_ = root.attribute("address").value();
  for (const auto child : root.children())
    if (std::string_view(child.name()) == "command")
      read_command(child);
    else if (child.type() == pugi::node_element)
      xml_.unknown(child, "<command>");
  if (read_.rules.commands.empty())
    xml_.error(root, "<service> has no <command>");
}

void Reader::read_command(const pugi::xml_node& node) {
  if (!xml_.check_attributes(node, {"name"}, {"params"}))
    return;
  CommandRule command;
  command.name = node.attribute("name").value();
  read_parameters_of(node, command);
  std::vector<std::string> names;
  for (const auto& parameter : command.parameters)
    names.push_back(parameter.name);
  request_line_ = 0;
  for (const auto child : node.children())
    if (child.type() == pugi::node_element)
      read_child(child, command, names);
  check_command(node, command);
  read_.rules.commands.push_back(std::move(command));
}

// Those of the role, unless the command names them itself.
void Reader::read_parameters_of(const pugi::xml_node& node,
                                CommandRule& command) {
  const auto* known = role_ ? role_->command(command.name) : nullptr;
  const auto given = node.attribute("params");
  if (given)
    command.parameters = read_parameters(given.value());
  else if (known)
    command.parameters = read_parameters(known->parameters);
  if (given && known &&
      command.parameters.size() != read_parameters(known->parameters).size())
    xml_.error(node, command.name + " of the role " + role_->name +
                         " has the parameters \"" + known->parameters +
                         "\"; params=\"…\" may give them other names");
}

void Reader::read_child(const pugi::xml_node& node, CommandRule& command,
                        const std::vector<std::string>& parameters) {
  const std::string_view name = node.name();
  if (const auto method = method_of_element(name))
    read_request(node, command, *method, parameters);
  else if (name == "on" || name == "otherwise")
    read_answer_rule(node, command, parameters);
  else if (name == "sample")
    read_sample(node, command);
  else
    xml_.unknown(node, "<get>, <post>, <put>, <patch>, <delete>, <on>, "
                       "<otherwise>, <sample>");
}

void Reader::read_request(const pugi::xml_node& node, CommandRule& command,
                          Method method,
                          const std::vector<std::string>& parameters) {
  if (request_line_ != 0)
    return xml_.error(node, "a command has one request, and line " +
                                std::to_string(request_line_) + " has it");
  request_line_ = xml_.line_of(node);
  command.request = RequestReader(xml_, environment_, address_, read_.missing)
                        .read(node, method, parameters);
}

void Reader::read_answer_rule(const pugi::xml_node& node, CommandRule& command,
                              const std::vector<std::string>& parameters) {
  AnswerRule rule;
  rule.line = xml_.line_of(node);
  if (!command.answers.empty() && command.answers.back().statuses.empty())
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
  command.answers.push_back(std::move(rule));
}

// Without a status every success counts.
void Reader::read_conditions(const pugi::xml_node& node, AnswerRule& rule) {
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

void Reader::read_event(const pugi::xml_node& node, EventRule& event,
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
void Reader::check_event(const pugi::xml_node& node, const EventRule& event) {
  const auto* known = role_ ? role_->event(event.name) : nullptr;
  if (known && known->reply == Reply::none)
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

void Reader::read_sample(const pugi::xml_node& node, CommandRule& command) {
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
  command.samples.push_back(std::move(sample));
}

void Reader::check_command(const pugi::xml_node& node,
                           const CommandRule& command) {
  if (read_.rules.find(command.name))
    xml_.error(node, "there is a command " + command.name + " already");
  if (request_line_ == 0)
    xml_.error(node,
               command.name + " has no request, such as <get url=\"…\"/>");
  if (command.answers.empty())
    xml_.error(node,
               command.name + " has no <on>, so that every answer would fail");
  if (xml_.has_errors())
    return;
  List parameters;
  for (const auto& parameter : command.parameters)
    parameters.push_back(sample_of(parameter));
  check_request(command, parameters);
  check_samples(command, parameters);
}

// Makes a request, as a conversation will.
void Reader::check_request(const CommandRule& command, const List& parameters) {
  const auto& rule = command.request;
  const auto request = make_request(command, parameters, "1");
  if (!request)
    return xml_.error(request_line_, request.error());
  if (const auto address = read_address(request->address);
      !address && !rule.server.empty())
    xml_.error(request_line_, "the address " + address.error());
  if (rule.body_type == BodyType::json && !read_json(request->body))
    xml_.error(request_line_,
               "the body is no JSON; names and texts stand in double quotes, "
               "also around a {parameter} that is a text");
}

// A sample of a failure may have no rule: the command then fails.
void Reader::check_samples(const CommandRule& command, const List& parameters) {
  for (const auto& sample : command.samples) {
    const auto made =
        read_answer(read_.rules, command, sample.answer, parameters);
    const bool is_failure =
        sample.answer.status < 200 || sample.answer.status > 299;
    if (!made && (!made.error().none_applies || !is_failure))
      xml_.error(sample.line, made.error().none_applies
                                  ? "no <on> applies to this sample"
                                  : "this sample does not fit its rule: " +
                                        made.error().reason);
  }
}

} // namespace

tl::expected<ReadRules, std::vector<Error>>
read_service_rules(std::string_view text, const std::string& file,
                   const Environment& environment, const std::string& address) {
  return Reader(text, file, environment, address).run();
}

} // namespace parlour::adapters::http
