// Markdown for entries. Sentences in the tables are plain text, so special
// characters are escaped, and tags are set as code.
#include "tools/parlour/reference/entry_page.hpp"

#include <cctype>
#include <string_view>

#include "tools/parlour/reference/entry_text.hpp"

namespace parlour::tools {

namespace {

// Whether "<name…>" begins at the position.
bool is_tag_at(const std::string& text, std::size_t at) {
  return text[at] == '<' && at + 1 < text.size() &&
         std::isalpha(static_cast<unsigned char>(text[at + 1])) &&
         text.find('>', at) != std::string::npos;
}

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// Plain text as Markdown: tags become code, and characters with a meaning in
// Markdown are escaped.
std::string markdown(const std::string& text) {
  constexpr std::string_view its_own = "*_[]|<`\\";
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (is_tag_at(text, at)) {
      const auto end = text.find('>', at);
      result += '`' + text.substr(at, end + 1 - at) + '`';
      at = end;
    } else if (text[at] == '(' && at > 0 && text[at - 1] == ']')
      result += "\\("; // would be a link
    else if (its_own.find(text[at]) != std::string_view::npos)
      result += {'\\', text[at]};
    else
      result += text[at];
  return result;
}

// Elements have a tag as their title; functions and roles do not.
bool is_tag(const Entry& entry) {
  return entry.title.front() == '<';
}

// The title of a function, such as "length(x)", is code.
std::string heading_of(const Entry& entry) {
  return entry.title.ends_with(')') ? '`' + entry.title + '`'
                                    : markdown(entry.title);
}

// The anchor that GitHub makes from a heading.
std::string anchor_of(const Entry& entry) {
  std::string anchor;
  for (const char c : entry.title)
    if (is_letter(c) || c == '_' || c == '-')
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c == ' ')
      anchor += '-';
  return anchor;
}

// A link from docs/reference to what `told` names.
std::string place_of(const std::string& told) {
  const auto text = place_text(told);
  const auto file = text.find('(');
  const auto path = file == std::string::npos
                        ? text
                        : text.substr(file + 1, text.size() - file - 2);
  const auto words =
      file == std::string::npos ? text : text.substr(0, file - 1);
  return "[" + words + "](../../" + path + ")";
}

// A fact as an item of a list.
std::string line_of(const Fact& fact) {
  return "* " + fact.label + ": " +
         (fact.label == "told in" ? place_of(fact.text) : markdown(fact.text)) +
         '\n';
}

// A detail as a row of the table.
std::string row_of(const Entry& entry, const Detail& detail) {
  return is_tag(entry) ? "| `" + detail.name + "` | " + markdown(detail.what) +
                             " | " + markdown(detail.sentence) + " |\n"
                       : "| " + detail.name + " | `" + detail.what + "` | " +
                             markdown(detail.sentence) + " |\n";
}

// Empty if the entry has no details.
std::string table_of(const Entry& entry) {
  if (entry.details.empty())
    return "";
  std::string rows = is_tag(entry) ? "| attribute | takes | what it is |\n"
                                   : "| it | what | |\n";
  rows += "| --- | --- | --- |\n";
  for (const auto& detail : entry.details)
    rows += row_of(entry, detail);
  return '\n' + rows;
}

// The example as a fenced block; empty if there is none.
std::string block_of(const Entry& entry) {
  return entry.example.empty()
             ? ""
             : std::string("\n```") + (is_tag(entry) ? "xml" : "text") + '\n' +
                   entry.example + "\n```\n";
}

} // namespace

std::string entry_section(const Entry& entry) {
  auto text =
      "## " + heading_of(entry) + "\n\n" + markdown(entry.sentence) + "\n\n";
  for (const auto& fact : entry.facts)
    text += line_of(fact);
  return text + table_of(entry) + block_of(entry);
}

std::string link_to(const Entry& entry, const std::string& page) {
  return "[" + heading_of(entry) + "](" + page + "#" + anchor_of(entry) + ")";
}

} // namespace parlour::tools
