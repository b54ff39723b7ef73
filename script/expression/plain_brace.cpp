#include "script/expression/plain_brace.hpp"

namespace parlour::script {

namespace {

constexpr int max_closings = 16; // tried for one opening brace

} // namespace

bool is_doubled(std::string_view text, std::size_t brace) {
  return brace + 1 < text.size() && text[brace + 1] == text[brace];
}

// An expression may contain closing braces itself, in maps and strings, so
// several candidates are tried.
Embedded embedded(std::string_view text, std::size_t brace) {
  auto close = text[brace] == '{' ? brace : std::string_view::npos;
  for (int tries = 0; tries < max_closings; ++tries) {
    if (close != std::string_view::npos)
      close = text.find('}', close + 1);
    if (close == std::string_view::npos)
      break;
    auto parsed = parse_expression(text.substr(brace + 1, close - brace - 1));
    if (parsed.node)
      return {std::move(parsed.node), close + 1};
  }
  return {};
}

std::size_t plain_brace(std::string_view text) {
  for (auto at = text.find_first_of("{}"); at != std::string_view::npos;
       at = text.find_first_of("{}", at)) {
    if (is_doubled(text, at)) {
      at += 2;
      continue;
    }
    const auto inside = embedded(text, at);
    if (!inside.node)
      return at;
    at = inside.end;
  }
  return std::string_view::npos;
}

} // namespace parlour::script
