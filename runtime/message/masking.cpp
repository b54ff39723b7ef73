#include "runtime/message/masking.hpp"

#include <algorithm>
#include <cctype>
#include <functional>

namespace parlour {

namespace {

constexpr std::size_t found_anywhere = 4; // bytes; shorter ones stand alone

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Bytes of multi-byte characters count as letters.
bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool is_between_digits(char c) {
  return c == ' ' || c == '-' || c == '.';
}

bool is_same(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) ==
         std::tolower(static_cast<unsigned char>(b));
}

// The length of the occurrence of `secret` at the start of `text`; 0 if it is
// not there. One blank, hyphen or point is skipped between two digits of the
// secret.
std::size_t length_of(std::string_view secret, std::string_view text) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < secret.size(); ++i) {
    const bool grouped = i > 0 && is_digit(secret[i - 1]) &&
                         is_digit(secret[i]) && at < text.size() &&
                         is_between_digits(text[at]);
    at += grouped ? 1 : 0;
    if (at >= text.size() || !is_same(secret[i], text[at]))
      return 0;
    ++at;
  }
  return at;
}

// Whether no letter or digit is beside the part [from, to).
bool stands_alone(std::string_view text, std::size_t from, std::size_t to) {
  return (from == 0 || !is_of_word(text[from - 1])) &&
         (to == text.size() || !is_of_word(text[to]));
}

// Copies a value of any depth and applies `change` to each text and number in
// it.
using Change = std::function<Value(const Value&)>;

Value changed(const Value& value, const Change& change) {
  if (const auto* list = value.if_list()) {
    List all;
    for (const auto& element : *list)
      all.push_back(changed(element, change));
    return all;
  }
  if (const auto* map = value.if_map()) {
    Map all;
    for (const auto& [key, element] : map->entries())
      all.set(key, changed(element, change));
    return all;
  }
  if (const auto* result = value.if_result()) {
    ResultSet all{result->columns, {}};
    for (const auto& cell : result->cells)
      all.cells.push_back(changed(cell, change));
    return all;
  }
  const bool is_shown =
      value.if_string() || value.if_integer() || value.if_number();
  return is_shown ? change(value) : value;
}

} // namespace

bool Secrets::add(std::string text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos)
    return false;
  text = text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
  if (std::ranges::count(texts_, text) > 0)
    return false;
  // Longer secrets come first, so that one that contains another is found
  // first.
  const auto shorter =
      std::ranges::find_if(texts_, [&](const std::string& known) {
        return known.size() < text.size();
      });
  texts_.insert(shorter, std::move(text));
  return true;
}

void Secrets::add(const Secrets& others) {
  for (const auto& text : others.texts_)
    add(text);
}

std::size_t Secrets::found_at(std::string_view text, std::size_t at) const {
  for (const auto& secret : texts_) {
    const auto length = length_of(secret, text.substr(at));
    if (length > 0 && (secret.size() >= found_anywhere ||
                       stands_alone(text, at, at + length)))
      return length;
  }
  return 0;
}

// Looks for a secret at each position; what was replaced is not searched again.
std::string Secrets::masked(std::string_view text) const {
  std::string shown;
  for (std::size_t at = 0; at < text.size();)
    if (const auto length = found_at(text, at)) {
      shown += mask;
      at += length;
    } else {
      shown += text[at++];
    }
  return shown;
}

Value Secrets::masked_value(const Value& value) const {
  return changed(value, [this](const Value& one) {
    const auto text = to_string(one);
    auto shown = masked(text);
    return shown == text ? one : Value(std::move(shown));
  });
}

Message Secrets::masked_message(Message message) const {
  for (auto& param : message.params)
    param = masked_value(param);
  return message;
}

Value all_masked(const Value& value) {
  return changed(value, [](const Value&) { return Value(mask); });
}

} // namespace parlour
