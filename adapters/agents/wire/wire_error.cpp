#include "adapters/agents/wire/wire_error.hpp"

#include <algorithm>
#include <array>

#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters::agents {
namespace {

// The table of errors without its sentences, which are for readers.
struct Row {
  std::string_view name;
  bool closes;
};

constexpr std::array rows = {
#define X(name, closes, sentence) Row{#name, closes},
#include "adapters/agents/wire/wire_errors.def"
#undef X
};

} // namespace

std::string_view name_of(WireErrorKind kind) {
  return rows.at(static_cast<std::size_t>(kind)).name;
}

std::optional<WireErrorKind> error_kind_of(std::string_view name) {
  const auto found = std::ranges::find(rows, name, &Row::name);
  if (found == rows.end())
    return std::nullopt;
  return static_cast<WireErrorKind>(found - rows.begin());
}

bool closes_connection(const WireError& error) {
  return error.loses_track ||
         rows.at(static_cast<std::size_t>(error.kind)).closes;
}

std::string excerpt(std::string_view text, std::size_t bytes) {
  if (text.size() > bytes) {
    while (bytes > 0 && continues_code_point(text[bytes]))
      --bytes;
    text = text.substr(0, bytes);
  }
  return std::string(text);
}

} // namespace parlour::adapters::agents
