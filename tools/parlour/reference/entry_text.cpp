// Text in columns: labels on the left, words on the right.
#include "tools/parlour/reference/entry_text.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "runtime/text/words.hpp"

namespace parlour::tools {

namespace {

// The column where words start, so that it fits the longest label.
std::size_t width_of(const Entry& entry) {
  std::size_t width = 0;
  for (const auto& fact : entry.facts)
    width = std::max(width, fact.label.size());
  for (const auto& detail : entry.details)
    width = std::max(width, detail.name.size());
  return width + 4; // indentation and gap
}

// Each line with two blanks in front, as the example of an entry.
std::string indented(const std::string& lines) {
  std::istringstream stream(lines);
  std::string text;
  for (std::string line; std::getline(stream, line);)
    text += "  " + line + '\n';
  return text;
}

// An attribute's sentence is left out if its kind ends with the same words.
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

// Each word is followed by a blank; at a line's end the blank becomes the line
// end.
std::string paragraph(const std::string& label, std::string_view words,
                      std::size_t column) {
  auto text = label + std::string(column - std::min(column, label.size()), ' ');
  auto used = text.size();
  for (const auto& word : split_words(words)) {
    if (used > column && used + word.size() > text_width) {
      text.back() = '\n';
      text += std::string(column, ' ');
      used = column;
    }
    text += word + ' ';
    used += word.size() + 1;
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

// Title and sentence, the facts, an empty line, the details, the example.
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
