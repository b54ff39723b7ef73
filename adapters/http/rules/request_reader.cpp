#include "adapters/http/rules/request_reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <pugixml.hpp>

#include "adapters/http/message/http_address.hpp"

namespace parlour::adapters::http {

namespace {

constexpr std::pair<std::string_view, Method> methods[] = {
    {"get", Method::get},
    {"post", Method::post},
    {"put", Method::put},
    {"patch", Method::patch},
    {"delete", Method::remove}};

constexpr std::array body_types = {
#define X(name, content_type) std::string_view(#name),
    PARLOUR_BODY_TYPES(X)
#undef X
};

// What the platform itself says of a connection and a body.
constexpr std::string_view own_headers[] = {
    "host", "content-length", "transfer-encoding", "connection", "expect"};

std::string lower(std::string text) {
  for (auto& byte : text)
    byte = static_cast<char>(std::tolower(static_cast<unsigned char>(byte)));
  return text;
}

// A name of a header, as RFC 9110 has it.
bool is_token(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](unsigned char byte) {
    return byte < 0x80 &&
           (std::isalnum(byte) ||
            std::string_view("!#$%&'*+-.^_`|~").find(static_cast<char>(byte)) !=
                std::string_view::npos);
  });
}

bool has_body(Method method) {
  return method == Method::post || method == Method::put ||
         method == Method::patch;
}

Error lacks_variable(const std::string& name, SourceLocation place) {
  return {ErrorKind::settings,
          "the environment has no '" + name + "', which these rules need",
          std::move(place)};
}

} // namespace

std::optional<Method> method_of_element(std::string_view element) {
  for (const auto& [name, method] : methods)
    if (name == element)
      return method;
  return std::nullopt;
}

// A rule with mistakes is returned as well: its answers are checked all the
// same.
RequestRule RequestReader::read(const pugi::xml_node& node, Method method,
                                const std::vector<std::string>& parameters) {
  names_ = {parameters, true, 0, environment_};
  RequestRule rule;
  rule.method = method;
  rule.may_repeat = is_idempotent(method);
  if (xml_.check_attributes(node, {"url"}, {"timeout", "retry"})) {
    read_address(node, rule);
    read_terms(node, rule);
  }
  for (const auto child : node.children())
    if (child.type() == pugi::node_element)
      read_part(child, rule);
  if (!rule.fields.empty() && rule.body_type)
    xml_.error(node, "a request has <field>s or a <body>, not both");
  return rule;
}

// `retry` has the last word, whatever method and headers say.
void RequestReader::read_terms(const pugi::xml_node& node, RequestRule& rule) {
  if (const auto timeout = node.attribute("timeout")) {
    const auto time = parse_duration(timeout.value());
    if (!time || *time <= Milliseconds::zero())
      xml_.error(node, "timeout=\"" + std::string(timeout.value()) +
                           "\" is no time such as 500ms or 5s");
    else
      rule.timeout = *time;
  }
  const std::string_view retry = node.attribute("retry").value();
  if (retry == "yes" || retry == "no")
    rule.may_repeat = retry == "yes";
  else if (node.attribute("retry"))
    xml_.error(node, "retry is \"yes\" or \"no\"");
}

// The server must be known now, so that no value of a conversation chooses it.
void RequestReader::read_address(const pugi::xml_node& node,
                                 RequestRule& rule) {
  std::string text = node.attribute("url").value();
  if (text.starts_with('/')) {
    if (address_.empty())
      return xml_.error(node, "url=\"" + text +
                                  "\" begins with \"/\", but the service has "
                                  "no address; write <service "
                                  "address=\"https://…\">");
    text.insert(0, address_.ends_with('/')
                       ? address_.substr(0, address_.size() - 1)
                       : address_);
  }
  bool is_whole = true;
  // What a variable holds is not read again: it may hold "${…}" itself.
  std::size_t at = 0;
  while (text.compare(at, 2, "${") == 0) {
    const auto end = text.find('}', at);
    if (end == std::string::npos)
      return xml_.error(node, "${ without its }");
    const auto value =
        with_variables(node, text.substr(at, end + 1 - at), is_whole);
    text.replace(at, end + 1 - at, value);
    at += value.size();
  }
  const auto scheme = text.find("://");
  const auto end = std::min(
      scheme == std::string::npos ? 0 : text.find_first_of("/?", scheme + 3),
      text.size());
  const auto server = with_variables(node, text.substr(0, end), is_whole);
  if (server.find('{') != std::string::npos)
    return xml_.error(node, "the server in an address cannot depend on a "
                            "parameter");
  const auto read = http::read_address(server);
  if (!read && is_whole)
    return xml_.error(node, "the address " + read.error());
  if (read)
    rule.server = read->server();
  rule.address = read_text(node, std::string_view(text).substr(end));
  rule.address.parts.insert(rule.address.parts.begin(),
                            {TemplatePart::Kind::text, server});
}

// With each ${NAME} replaced by its value. `is_whole` becomes false if the
// environment lacks one.
// For the server's name only: its variables are no secrets.
std::string RequestReader::with_variables(const pugi::xml_node& node,
                                          std::string text, bool& is_whole) {
  for (auto at = text.find("${"); at != std::string::npos;
       at = text.find("${", at)) {
    const auto end = text.find('}', at);
    if (end == std::string::npos)
      break;
    const auto name = text.substr(at + 2, end - at - 2);
    const auto value = environment_ ? environment_(name) : "";
    if (value.empty()) {
      is_whole = false;
      missing_.push_back(lacks_variable(name, xml_.place_of(node)));
    }
    text.replace(at, end + 1 - at, value);
    at += value.size();
  }
  return text;
}

// A GET with a body is refused by some servers and ignored by others.
void RequestReader::read_part(const pugi::xml_node& node, RequestRule& rule) {
  const std::string_view name = node.name();
  const bool is_of_body = name == "field" || name == "body";
  if (is_of_body && !has_body(rule.method))
    return xml_.error(node, "a " + std::string(name_of(rule.method)) +
                                " has no body; write values as <query>, or "
                                "take <post>");
  if (name == "query")
    rule.queries.push_back(named(node));
  else if (name == "field")
    rule.fields.push_back(named(node));
  else if (name == "header")
    read_header(node, rule);
  else if (name == "body")
    read_body(node, rule);
  else
    xml_.unknown(node, "<query>, <header>, <field>, <body>");
}

void RequestReader::read_header(const pugi::xml_node& node, RequestRule& rule) {
  auto header = named(node);
  const auto name = lower(header.name);
  if (header.name.empty())
    return;
  if (!is_token(header.name))
    return xml_.error(node, "'" + header.name + "' is no name of a header");
  if (std::ranges::count(own_headers, name) > 0)
    return xml_.error(node, "the header " + header.name +
                                " is written by the platform itself");
  if (name == "content-type")
    header.name = "Content-Type";
  // The service recognises a second request as the first one.
  if (name == "idempotency-key" && !node.parent().attribute("retry"))
    rule.may_repeat = true;
  rule.headers.push_back(std::move(header));
}

// In JSON it is noted now which values stand between quotes.
void RequestReader::read_body(const pugi::xml_node& node, RequestRule& rule) {
  if (!xml_.check_attributes(node, {"type"}))
    return;
  const std::string_view type = node.attribute("type").value();
  const auto found = std::ranges::find(body_types, type);
  if (found == body_types.end())
    return xml_.error(node, "type=\"" + std::string(type) +
                                "\" is no type of a body; there are json, "
                                "xml and text, and <field> for forms");
  if (rule.body_type)
    return xml_.error(node, "a request has one <body>");
  rule.body_type = static_cast<BodyType>(found - body_types.begin());
  rule.body = read_text(node, text_of(node));
  if (rule.body_type == BodyType::json)
    mark_quoted(rule.body);
}

NamedTemplate RequestReader::named(const pugi::xml_node& node) {
  if (!xml_.check_attributes(node, {"name"}, {"value"}))
    return {};
  return {node.attribute("name").value(),
          read_text(node, node.attribute("value").value())};
}

// A variable that is missing is no mistake of the rules: it may be there where
// the application runs.
TextTemplate RequestReader::read_text(const pugi::xml_node& node,
                                      std::string_view text) {
  std::vector<std::string> lacking;
  auto read = read_template(text, names_, lacking);
  for (const auto& name : lacking)
    missing_.push_back(lacks_variable(name, xml_.place_of(node)));
  if (read)
    return std::move(*read);
  xml_.error(node, read.error());
  return {};
}

} // namespace parlour::adapters::http
