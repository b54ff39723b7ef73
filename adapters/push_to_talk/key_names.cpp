#include "adapters/push_to_talk/key_names.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <fmt/format.h>
#include <linux/input-event-codes.h>

namespace parlour::adapters {

namespace {

struct Named {
  std::string_view name;
  std::uint16_t code;
  char typed = 0; // 0: a terminal sends nothing, or several bytes
};

// A terminal sends a carriage return; without its line discipline it stays one.
constexpr std::array<Named, 16> special = {{
    {"space", KEY_SPACE, ' '},
    {"enter", KEY_ENTER, '\r'},
    {"tab", KEY_TAB, '\t'},
    {"left-ctrl", KEY_LEFTCTRL},
    {"right-ctrl", KEY_RIGHTCTRL},
    {"left-shift", KEY_LEFTSHIFT},
    {"right-shift", KEY_RIGHTSHIFT},
    {"left-alt", KEY_LEFTALT},
    {"right-alt", KEY_RIGHTALT},
    {"page-up", KEY_PAGEUP},
    {"page-down", KEY_PAGEDOWN},
    {"pause", KEY_PAUSE},
    {"scroll-lock", KEY_SCROLLLOCK},
    {"play", KEY_PLAYPAUSE},
    {"headset", KEY_MEDIA},
    {"menu", KEY_COMPOSE},
}};

// Letters and figures, by the rows of a keyboard.
struct Row {
  std::string_view keys;
  std::uint16_t first;
};
constexpr std::array<Row, 4> rows = {{{"1234567890", KEY_1},
                                      {"qwertyuiop", KEY_Q},
                                      {"asdfghjkl", KEY_A},
                                      {"zxcvbnm", KEY_Z}}};

constexpr std::string_view code_prefix = "code-";

std::optional<std::uint16_t> number(std::string_view text, int most) {
  int value = 0;
  const auto* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || at != end || value < 1 || value > most)
    return std::nullopt;
  return static_cast<std::uint16_t>(value);
}

std::optional<KeyName> single(char key) {
  for (const auto& row : rows)
    if (const auto at = row.keys.find(key); at != std::string_view::npos)
      return KeyName{static_cast<std::uint16_t>(row.first + at), key};
  return std::nullopt;
}

// "f11" does not follow "f10".
std::optional<KeyName> function_key(std::string_view name) {
  if (!name.starts_with('f'))
    return std::nullopt;
  const auto which = number(name.substr(1), 12);
  if (!which)
    return std::nullopt;
  return KeyName{static_cast<std::uint16_t>(*which <= 10
                                                ? KEY_F1 + *which - 1
                                                : KEY_F11 + *which - 11),
                 {}};
}

std::optional<KeyName> by_code(std::string_view name) {
  if (!name.starts_with(code_prefix))
    return std::nullopt;
  const auto code = number(name.substr(code_prefix.size()), KEY_MAX);
  return code ? std::optional(KeyName{code, {}}) : std::nullopt;
}

} // namespace

Expected<KeyName> find_key(const std::string& name) {
  if (name == "any")
    return KeyName{};
  const auto found = std::ranges::find(special, name, &Named::name);
  if (found != special.end())
    return KeyName{found->code,
                   found->typed ? std::optional(found->typed) : std::nullopt};
  if (name.size() == 1)
    if (const auto key = single(name.front()))
      return *key;
  if (const auto key = function_key(name))
    return *key;
  if (const auto key = by_code(name))
    return *key;
  std::string all;
  for (const auto& one : special)
    all += std::string(one.name) + ", ";
  return fail(ErrorKind::settings,
              fmt::format("\"{}\" is no key; there are a to z, 0 to 9, f1 to "
                          "f12, {}code-1 to code-{}, and any",
                          name, all, KEY_MAX));
}

} // namespace parlour::adapters
