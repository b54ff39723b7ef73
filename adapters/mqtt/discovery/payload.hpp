// Payload is the text of an MQTT message. Several devices may read the same
// one, so it is parsed as JSON once, and only if one of them needs that.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "runtime/base/value.hpp"
#include "runtime/text/json_text.hpp"

namespace parlour::adapters::mqtt {

// A value as Home Assistant's templates write it: True, False, None; a text as
// it is; a list or an object as JSON.
std::string text_of(const Value& value);

// Made for one message, used while it is handled.
// Not thread-safe.
class Payload {
public:
  explicit Payload(std::string text) : text_(std::move(text)) {}

  const std::string& text() const {
    return text_;
  }
  // Null if the text is no JSON; is_broken() tells so from then on.
  const Value* json() const;
  bool is_broken() const {
    return json_ && !*json_;
  }

private:
  const std::string text_;
  mutable std::optional<tl::expected<Value, JsonFault>> json_;
};

} // namespace parlour::adapters::mqtt
