#include "adapters/http/rules/request_maker.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "adapters/http/message/http_address.hpp"
#include "runtime/text/json_text.hpp"

namespace parlour::adapters::http {

namespace {

using Kind = TemplatePart::Kind;
using Unexpected = tl::unexpected<std::string>;
using Text = tl::expected<std::string, std::string>;

// What templates are filled with.
// Values of the conversation are data: wherever they are put in, they are
// written so that they cannot become a part of the address, of JSON or of XML.
//
// How a value is written, by the place where it stands:
//
//   in the address, a <query>, a <field>   as %XX
//   in a <header>                          as it is; no line ends
//   in JSON, between quotes                as a part of a text, with \" for "
//   in JSON, elsewhere                     as JSON: 5, true, null, "a"
//   in XML                                 with &lt; for <
struct Filling {
  const List& parameters;
  const std::string& request_id;

  Value value_of(const TemplatePart& part) const {
    switch (part.kind) {
    case Kind::parameter:
      return part.number < parameters.size() ? parameters[part.number]
                                             : Value();
    case Kind::request_id:
      return request_id;
    default:
      return part.text;
    }
  }
  // What is not there is empty.
  std::string text_of(const TemplatePart& part) const {
    const auto value = value_of(part);
    return value.is_unknown() ? "" : value.text();
  }
};

// The template with each value passed through `escape`; its own text is the
// application's, and is written as it stands.
template <class Escape>
std::string filled(const TextTemplate& text, const Filling& filling,
                   Escape escape) {
  std::string result;
  for (const auto& part : text.parts)
    result +=
        part.kind == Kind::text ? part.text : escape(filling.text_of(part));
  return result;
}

// In the path a value must be there: without it the address would mean
// something else.
Text address_of(const RequestRule& rule, const Filling& filling) {
  std::string address;
  for (const auto& part : rule.address.parts) {
    const auto text = filling.text_of(part);
    const bool is_in_path = address.find('?') == std::string::npos;
    if (part.kind == Kind::parameter && text.empty() && is_in_path)
      return Unexpected("'" + part.text +
                        "' is empty, but the address needs "
                        "it.");
    address += part.kind == Kind::text ? part.text : percent_encoded(text);
  }
  // The path follows the first "/" behind "https://".
  const auto path = address.find('/', address.find("://") + 3);
  if (path != std::string::npos && has_dot_segment(address.substr(path)))
    return Unexpected("'.' and '..' cannot be a part of an address.");
  return address;
}

// A <query> or <field> whose value is a parameter that is not given is left
// out.
bool is_left_out(const TextTemplate& value, const Filling& filling) {
  const auto* part = value.single();
  return part && part->kind == Kind::parameter &&
         filling.value_of(*part).is_unknown();
}

// "a=b&c=d".
std::string pairs(const std::vector<NamedTemplate>& all,
                  const Filling& filling) {
  std::string text;
  for (const auto& [name, value] : all)
    if (!is_left_out(value, filling))
      text +=
          (text.empty() ? "" : "&") + percent_encoded(name) + '=' +
          percent_encoded(filled(value, filling, [](auto one) { return one; }));
  return text;
}

// A line end would begin another header.
tl::expected<std::vector<HttpHeader>, std::string>
headers_of(const RequestRule& rule, const Filling& filling) {
  std::vector<HttpHeader> headers;
  for (const auto& [name, value] : rule.headers) {
    if (is_left_out(value, filling))
      continue;
    auto text = filled(value, filling, [](auto one) { return one; });
    if (std::ranges::any_of(text, [](unsigned char byte) {
          return (byte < ' ' && byte != '\t') || byte == 0x7f;
        }))
      return Unexpected("The header " + name +
                        " cannot have line ends or control characters.");
    headers.push_back({name, std::move(text), value.has(Kind::secret)});
  }
  return headers;
}

std::string without_quotes(const std::string& json) {
  return json.substr(1, json.size() - 2);
}

// Between quotes a value is a part of a text; elsewhere it is a value.
// In {"to": "{number}", "count": {count}} the first is a text, whatever it is.
std::string json_of(const TextTemplate& text, const Filling& filling) {
  std::string result;
  for (const auto& part : text.parts)
    if (part.kind == Kind::text)
      result += part.text;
    else if (part.is_quoted)
      result += without_quotes(json_text(filling.text_of(part)));
    else
      result += json_text(filling.value_of(part));
  return result;
}

// Control characters cannot be in XML at all.
std::string xml_escaped(const std::string& text) {
  std::string result;
  for (const char one : text)
    switch (one) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    case '\'':
      result += "&apos;";
      break;
    default:
      result += static_cast<unsigned char>(one) < ' ' && one != '\t' &&
                        one != '\n' && one != '\r'
                    ? ' '
                    : one;
    }
  return result;
}

// Without a <body> it is a form, which may be empty.
std::string body_of(const RequestRule& rule, const Filling& filling) {
  if (!rule.body_type)
    return pairs(rule.fields, filling);
  switch (*rule.body_type) {
  case BodyType::json:
    return json_of(rule.body, filling);
  case BodyType::xml:
    return filled(rule.body, filling, xml_escaped);
  case BodyType::text:
    return filled(rule.body, filling, [](auto one) { return one; });
  }
  return {};
}

std::string_view content_type(BodyType type) {
  constexpr std::string_view types[] = {
#define X(name, content_type) content_type,
      PARLOUR_BODY_TYPES(X)
#undef X
  };
  return types[static_cast<std::size_t>(type)];
}

// Unless the rule says it.
void add_content_type(const RequestRule& rule,
                      std::vector<HttpHeader>& headers) {
  const bool is_said =
      std::ranges::count(headers, "Content-Type", &HttpHeader::name) > 0;
  if (is_said || (!rule.body_type && rule.fields.empty()))
    return;
  headers.push_back({"Content-Type",
                     rule.body_type ? std::string(content_type(*rule.body_type))
                                    : "application/x-www-form-urlencoded"});
}

// The first parameter that is neither there nor optional; null if there is
// none.
const Parameter* missing(const CommandRule& rule, const List& parameters) {
  for (std::size_t i = 0; i < rule.parameters.size(); ++i)
    if (!rule.parameters[i].optional &&
        (i >= parameters.size() || parameters[i].is_unknown()))
      return &rule.parameters[i];
  return nullptr;
}

} // namespace

// All checks come before anything is sent: a value that is missing or too long,
// or that would change the address.
tl::expected<HttpRequest, std::string>
make_request(const CommandRule& rule, const List& parameters,
             const std::string& request_id) {
  if (const auto* lacking = missing(rule, parameters))
    return Unexpected(rule.name + " needs '" + lacking->name + "'.");
  const Filling filling{parameters, request_id};
  auto address = address_of(rule.request, filling);
  if (!address)
    return Unexpected(std::move(address.error()));
  if (const auto query = pairs(rule.request.queries, filling); !query.empty())
    *address += (address->find('?') == std::string::npos ? "?" : "&") + query;
  auto headers = headers_of(rule.request, filling);
  if (!headers)
    return Unexpected(std::move(headers.error()));
  add_content_type(rule.request, *headers);
  auto body = body_of(rule.request, filling);
  if (address->size() > max_address || body.size() > max_body)
    return Unexpected("The values of " + rule.name +
                      " are too long to be sent.");
  return HttpRequest{rule.request.method,     std::move(*address),
                     std::move(*headers),     std::move(body),
                     rule.request.may_repeat, rule.request.timeout};
}

} // namespace parlour::adapters::http
