#include "adapters/http/rules/rules_reader.hpp"

#include <algorithm>
#include <utility>

#include <pugixml.hpp>

#include "adapters/http/message/http_address.hpp"
#include "adapters/http/rules/answer_reader.hpp"
#include "adapters/http/rules/answer_rule_reader.hpp"
#include "adapters/http/rules/request_maker.hpp"
#include "adapters/http/rules/request_reader.hpp"
#include "runtime/text/json_text.hpp"

namespace parlour::adapters::http {

namespace {

// Reads one file.
// Mistakes are collected; what is wrong is left out or incomplete, and the
// reading goes on, so that one check tells all of them.
//
// Who reads what:
//
//   <service>                    this, with RulesXml for the mistakes
//     <command>, <webhook>       this
//       <get>, <post>, ...       RequestReader
//       <on>, <otherwise>        AnswerRuleReader
//       <sample>                 AnswerRuleReader
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
  void read_webhook(const pugi::xml_node& node);
  void read_parameters_of(const pugi::xml_node& node, CommandRule& command);
  void read_child(const pugi::xml_node& node, CommandRule& command,
                  const std::vector<std::string>& parameters);
  void read_request(const pugi::xml_node& node, CommandRule& command,
                    Method method, const std::vector<std::string>& parameters);
  void check_command(const pugi::xml_node& node, const CommandRule& command);
  void check_request(const CommandRule& command, const List& parameters);
  void check_samples(const std::vector<AnswerRule>& answers,
                     const std::string& subject,
                     const std::vector<SampleRule>& samples,
                     const List& parameters);

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
    else if (std::string_view(child.name()) == "webhook")
      read_webhook(child);
    else if (child.type() == pugi::node_element)
      xml_.unknown(child, "<command> and <webhook>");
  if (read_.rules.commands.empty() && read_.rules.webhooks.empty())
    xml_.error(root, "<service> has no <command> and no <webhook>");
}

// Its events come unasked, so they need not end a request.
void Reader::read_webhook(const pugi::xml_node& node) {
  if (!xml_.check_attributes(node, {"path"}))
    return;
  WebhookRule webhook;
  webhook.path = node.attribute("path").value();
  if (!webhook.path.starts_with('/') ||
      webhook.path.find('?') != std::string::npos)
    xml_.error(node, "path=\"" + webhook.path +
                         "\" begins with \"/\" and has no \"?\"");
  if (read_.rules.find_webhook(webhook.path))
    xml_.error(node, "there is a webhook " + webhook.path + " already");
  AnswerRuleReader answers(xml_, role_, AnswerRuleReader::Of::webhook);
  for (const auto child : node.children()) {
    const std::string_view name = child.name();
    if (name == "on" || name == "otherwise")
      answers.read(child, {}, webhook.answers);
    else if (name == "sample")
      answers.read_sample(child, webhook.samples);
    else if (child.type() == pugi::node_element)
      xml_.unknown(child, "<on>, <otherwise>, <sample>");
  }
  if (webhook.answers.empty())
    xml_.error(node, "a webhook needs an <on>, which makes an event of it");
  if (!xml_.has_errors())
    check_samples(webhook.answers, "A report comes", webhook.samples, {});
  read_.rules.webhooks.push_back(std::move(webhook));
}

// A command is tried out at once with values of its parameters' types.
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

// The request and the answers may stand in any order; answers count in theirs.
void Reader::read_child(const pugi::xml_node& node, CommandRule& command,
                        const std::vector<std::string>& parameters) {
  const std::string_view name = node.name();
  AnswerRuleReader answers(xml_, role_, AnswerRuleReader::Of::command);
  if (const auto method = method_of_element(name))
    read_request(node, command, *method, parameters);
  else if (name == "on" || name == "otherwise")
    answers.read(node, parameters, command.answers);
  else if (name == "sample")
    answers.read_sample(node, command.samples);
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

// Where there are mistakes already, trying it out would only repeat them.
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
  check_samples(command.answers, command.who_answered(), command.samples,
                parameters);
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
// The samples are the tests of the rules: each has to become an event.
void Reader::check_samples(const std::vector<AnswerRule>& answers,
                           const std::string& subject,
                           const std::vector<SampleRule>& samples,
                           const List& parameters) {
  for (const auto& sample : samples) {
    const auto made = read_answer(answers, read_.rules.file, subject,
                                  sample.answer, parameters);
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
