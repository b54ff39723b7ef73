// ValueTemplate takes a value out of a payload, or puts one into a command, as
// Home Assistant's templates do. Of their language it knows what devices that
// announce themselves use:
//
//  {{ value }}                          the payload
//  {{ value_json.state }}               a part of it, which is JSON
//  {{ value_json['a b'].list[0] }}
//  {{ value_json.t | float | round(1) }}
//
// with texts before, between and behind. The filters are float, int, round,
// lower, upper, string, default and is_defined. Anything else (conditions,
// arithmetic, statements) is refused when the template is read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "adapters/mqtt/discovery/payload.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::mqtt {

// Immutable.
class ValueTemplate {
public:
  // "{{ value }}"
  ValueTemplate();

  // The error, of kind Settings, quotes what is not understood.
  static Expected<ValueTemplate> parse(std::string_view text);

  // The text that the template makes of the payload; nothing if a part that it
  // names is missing, or if the payload is no JSON (Payload::is_broken()).
  std::optional<std::string> apply(const Payload& payload) const;

private:
  friend class TemplateReader;

  struct Filter {
    std::string name;
    std::optional<Value> argument;
  };
  // A member's name, or the position in a list.
  using Step = std::variant<std::string, std::size_t>;
  struct Expression {
    bool is_json = false;
    std::vector<Step> path;
    std::vector<Filter> filters;
  };
  using Piece = std::variant<std::string, Expression>;

  static std::optional<Value> find(const Expression& expression,
                                   const Payload& payload);
  static bool filter(std::optional<Value>& value, const Filter& filter);
  static std::optional<std::string> evaluate(const Expression& expression,
                                             const Payload& payload);

  std::vector<Piece> pieces_;
};

} // namespace parlour::adapters::mqtt
