#include "script/dialogue/engine/effect_deeds.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace parlour::dialogue {

namespace {

bool only_looks(const std::string& sql) {
  const auto start = sql.find_first_not_of(" \t\r\n");
  return start != std::string::npos &&
         std::ranges::equal(sql.substr(start, 6), std::string_view("select"),
                            [](unsigned char one, char other) {
                              return std::tolower(one) == other;
                            });
}

} // namespace

bool is_deed(const script::Effect& effect) {
  using enum script::EffectKind;
  switch (effect.kind) {
  case confirm:
  case wait:
  case log:
  case print:
  case ask:
  case clear:
  case complete:
  case consume:
  case connectdb:
  case read_file:
  case list_files:
    return false;
  case querydb:
    return !only_looks(effect.text(0));
  default:
    return true;
  }
}

} // namespace parlour::dialogue
