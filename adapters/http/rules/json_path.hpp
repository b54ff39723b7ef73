// JsonPath names a place in the JSON of an answer:
//
//  /current/temperature   the entry of an entry
//  /days/0/text           the first element of a list
//  /days/*/text           a list: the text of each day
//  /                      the whole answer
//
// It is a JSON Pointer (RFC 6901: "~1" is a "/" in a key, "~0" a "~") with "*"
// in addition.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/value.hpp"

namespace parlour::adapters::http {

// Immutable.
// Written in rules of services; read once, followed in each answer.
class JsonPath {
public:
  JsonPath() = default; // the whole answer
  // `text` begins with "/".
  explicit JsonPath(std::string_view text);

  // What is there; nothing if there is no such entry. With "*" a list of all
  // that is found, which may be empty.
  std::optional<Value> find(const Value& value) const;

  // As it was written.
  const std::string& text() const {
    return text_;
  }

private:
  std::optional<Value> find(const Value& value, std::size_t step) const;
  std::optional<Value> find_all(const Value& value, std::size_t step) const;

  std::string text_ = "/";
  std::vector<std::string> steps_; // still encoded
};

} // namespace parlour::adapters::http
