#include "tools/parlour/reference/entry_text.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace parlour::tools {

namespace {

std::size_t width_of(const Entry& entry) {
  std::size_t width = 0;
  for (const auto& fact : entry.facts)
    width = std::max(width, fact.label.size());
  for (const auto& detail : entry.details)
    width = std::max(width, detail.name.size());
  return width + 4; // two blanks on both sides
}

std::string indented(const std::string& lines) {
  std::istringstream stream(lines);
  std::string text;
  for (std::string line; std::getline(stream, line);)
    text += "  " + line + '\n';
  return text;
}

std::string text_of(const Detail& detail, std::size_t column) {
  const bool is_said = detail.what.ends_with(detail.sentence); // or empty
  return paragraph("  " + detail.name,
                   detail.what + (is_said ? "" : "; " + detail.sentence),
                   column);
}

std::string text_of(const Fact& fact, std::size_t column) {
  return paragraph("  " + fact.label,
                   fact.label == "told in" ? place_text(fact.text) : fact.text,
                   column);
}

} // namespace

std::string paragraph(const std::string& label, std::string_view words,
                      std::size_t column) {
  std::istringstream stream{std::string(words)};
  auto text = label + std::string(column - std::min(column, label.size()), ' ');
  auto used = text.size();
  for (std::string word; stream >> word; used += word.size() + 1) {
    if (used > column && used + word.size() > text_width) {
      text.back() = '\n';
      text += std::string(column, ' ');
      used = column;
    }
    text += word + ' ';
  }
  text.back() = '\n';
  return text;
}

std::string place_text(const std::string& told) {
  if (told.starts_with("engine "))
    return "engine rule " + told.substr(7) + " (docs/engine.md)";
  if (std::isdigit(static_cast<unsigned char>(told.front())))
    return "language rule " + told + " (script/LANGUAGE.md)";
  return told;
}

std::string entry_text(const Entry& entry) {
  const auto column = width_of(entry);
  auto text =
      paragraph(entry.title + ":", entry.sentence, entry.title.size() + 2);
  for (const auto& fact : entry.facts)
    text += text_of(fact, column);
  text += entry.facts.empty() || entry.details.empty() ? "" : "\n";
  for (const auto& detail : entry.details)
    text += text_of(detail, column);
  return text + (entry.example.empty() ? "" : "\n" + indented(entry.example));
}

} // namespace parlour::tools
