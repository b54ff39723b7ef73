// TextTemplate is a text of the rules with places for values:
//
//  {place}            a parameter of the command
//  ${WEATHER_KEY}     a variable of the environment: a secret
//  {request.id}       a text of its own for each request
//  {/current/text}    a place in the JSON of the answer
//  {0} {1}            the text of the answer or its match; a group of it
//
// Any other brace is a brace, so JSON can be written as it is.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "adapters/http/rules/json_path.hpp"

namespace parlour::adapters::http {

// The value of a variable of the environment; empty: it has none.
using Environment = std::function<std::string(const std::string& name)>;

// Which fields count depends on the kind.
struct TemplatePart {
  enum class Kind : std::uint8_t {
    text,
    parameter,
    secret,
    request_id,
    path,
    group
  };

  Kind kind = Kind::text;
  // The text itself, a secret's value, or a parameter's name.
  std::string text;
  // Of a parameter or a group.
  std::size_t number = 0;
  JsonPath path = {};
  // In a body of JSON: it stands between quotes.
  bool is_quoted = false;
};

struct TextTemplate {
  std::vector<TemplatePart> parts;

  bool has(TemplatePart::Kind kind) const;
  // The only part, if there is exactly one.
  const TemplatePart* single() const;
};

// What a template may name.
struct TemplateNames {
  std::vector<std::string> parameters = {};
  // A request may have secrets and {request.id}; an event may have what is in
  // the answer.
  bool is_request = true;
  // The highest number of a group.
  std::size_t groups = 0;
  Environment environment = {};
};

// The template, or what is wrong with it, as a sentence without its place.
// Variables that the environment lacks are added to `missing`; they are empty.
tl::expected<TextTemplate, std::string>
read_template(std::string_view text, const TemplateNames& names,
              std::vector<std::string>& missing);

// Marks the parts that stand within a string of JSON.
void mark_quoted(TextTemplate& json);

} // namespace parlour::adapters::http
