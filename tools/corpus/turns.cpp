#include "tools/corpus/turns.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace parlour::tools::corpus {

namespace {

struct Form {
  std::string_view name;
  std::size_t fields;
};

// In the order of LineKind.
constexpr std::array forms = {
#define X(name, fields, sentence) Form{#name, fields},
    PARLOUR_CORPUS_LINES(X)
#undef X
};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (auto tab = text.find('\t'); tab != std::string::npos;
       from = tab + 1, tab = text.find('\t', from))
    parts.push_back(text.substr(from, tab - from));
  parts.push_back(text.substr(from));
  return parts;
}

// The kind of a line by its first field.
std::optional<LineKind> kind_of(std::string_view name) {
  for (std::size_t i = 0; i < forms.size(); ++i)
    if (forms[i].name == name)
      return static_cast<LineKind>(i);
  return std::nullopt;
}

} // namespace

Expected<Line> parse_line(const std::string& text) {
  auto fields = split(text);
  const auto kind = kind_of(fields.front());
  if (!kind)
    return fail(ErrorKind::settings,
                "there is no line '" + fields.front() + "'");
  fields.erase(fields.begin());
  const auto wanted = forms[static_cast<std::size_t>(*kind)].fields;
  // Only `is` may have more fields: the ways to write a value.
  if (fields.size() < wanted ||
      (fields.size() > wanted && *kind != LineKind::is))
    return fail(ErrorKind::settings,
                "'" + std::string(forms[static_cast<std::size_t>(*kind)].name) +
                    "' takes " + std::to_string(wanted) + " fields, not " +
                    std::to_string(fields.size()));
  return Line{*kind, std::move(fields)};
}

Expected<std::vector<Line>> TurnReader::next() {
  auto lines = std::exchange(ahead_, {});
  for (std::string text; std::getline(input_, text);) {
    ++number_;
    auto line = parse_line(text);
    if (line && lines.empty() && line->kind != LineKind::dialogue)
      line = fail(ErrorKind::settings, "a dialogue begins by 'dialogue'");
    if (!line) {
      line.error().place.line = number_;
      return tl::make_unexpected(line.error());
    }
    // The next dialogue begins: its first line is kept for the next call.
    if (line->kind == LineKind::dialogue && !lines.empty()) {
      ahead_.push_back(std::move(*line));
      return lines;
    }
    lines.push_back(std::move(*line));
  }
  return lines;
}

} // namespace parlour::tools::corpus
