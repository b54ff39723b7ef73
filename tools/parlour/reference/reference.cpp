// Searches all entries. There are a few hundred, so each search goes through
// them in turn.
#include "tools/parlour/reference/reference.hpp"

#include <algorithm>
#include <cctype>

#include "runtime/message/roles.hpp"
#include "script/source/findings.hpp"
#include "script/source/source.hpp"
#include "tools/parlour/reference/element_entry.hpp"
#include "tools/parlour/reference/entry_text.hpp"
#include "tools/parlour/reference/function_entry.hpp"
#include "tools/parlour/reference/role_entry.hpp"

namespace parlour::tools {

namespace {

using Entries = std::vector<Entry>;
using Lines = std::vector<std::string>;

// More lines than this are joined to one paragraph of names.
constexpr std::size_t max_lines = 16;

bool is_element(const Entry& entry) {
  return entry.title.front() == '<';
}

// An element's first letter may have either case (language rule 1.4); a role is
// also found by an alias.
bool is_called(const Entry& entry, const std::string& name) {
  if (is_element(entry))
    return script::same_name(entry.name, name);
  const auto* role = find_role(name);
  return entry.name == (role ? role->name : name);
}

// All entries, made once.
const Entries& all_entries() {
  static const Entries all = [] {
    auto entries = element_entries();
    for (const auto& more : {function_entries(), role_entries()})
      entries.insert(entries.end(), more.begin(), more.end());
    return entries;
  }();
  return all;
}

// What a detail belongs to and is called: "<speak interrupt>", "TTS fires
// Audio(audio, utterance)".
std::string place_of(const Entry& entry, const Detail& detail) {
  if (!is_element(entry))
    return entry.name + ' ' + detail.name + ' ' + detail.what;
  auto tag = entry.title;
  return tag.insert(tag.find('>'), ' ' + detail.name);
}

// The name under which a detail is looked up: "Audio" for "Audio(audio,
// utterance)".
std::string name_of(const Entry& entry, const Detail& detail) {
  return is_element(entry) ? detail.name
                           : detail.what.substr(0, detail.what.find('('));
}

// What it belongs to, and its sentence.
std::string line_of(const Entry& entry, const Detail& detail) {
  const auto& words = detail.sentence;
  return place_of(entry, detail) + (words.empty() ? "" : ": " + words);
}

std::string lowered(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// Whether the word stands in the sentence as a whole word. `word` is in small
// letters.
bool stands_in(const std::string& word, const std::string& sentence) {
  const auto text = ' ' + lowered(sentence) + ' ';
  for (auto at = text.find(word); at != std::string::npos;
       at = text.find(word, at + 1))
    if (!is_letter(text[at - 1]) && !is_letter(text[at + word.size()]))
      return true;
  return false;
}

// Leaves out the placeholders for names that applications choose.
void add_once(Lines& names, const std::string& name) {
  if (name != "*" && name != "NAME" && std::ranges::count(names, name) == 0)
    names.push_back(name);
}

// The lines up to their first colon.
Lines without_sentences(Lines lines) {
  for (auto& line : lines)
    line.erase(std::min(line.find(": "), line.size()));
  return lines;
}

// Adds lines under a heading; nothing if there are none.
void add_lines(std::string& text, const std::string& heading,
               const Lines& lines) {
  if (lines.empty())
    return;
  text += (text.empty() ? "" : "\n") + heading + '\n';
  if (lines.size() > max_lines)
    text += paragraph("  ", listed(without_sentences(lines)), 2);
  else
    for (const auto& line : lines)
      text += paragraph("  ", line, 4);
}

} // namespace

Entries entries_of(const std::string& name) {
  Entries found;
  for (const auto& entry : all_entries())
    if (is_called(entry, name))
      found.push_back(entry);
  if (name == statements_entry().name)
    found.push_back(statements_entry());
  return found;
}

Lines holders_of(const std::string& name) {
  Lines lines;
  for (const auto& entry : all_entries())
    for (const auto& detail : entry.details)
      if (name_of(entry, detail) == name)
        lines.push_back(line_of(entry, detail));
  return lines;
}

Lines mentions_of(const std::string& word) {
  Lines lines;
  const auto small = lowered(word);
  for (const auto& entry : all_entries()) {
    if (stands_in(small, entry.sentence))
      lines.push_back(entry.title + ": " + entry.sentence);
    for (const auto& detail : entry.details)
      if (stands_in(small, detail.sentence))
        lines.push_back(line_of(entry, detail));
  }
  return lines;
}

Lines reference_names() {
  Lines names;
  for (const auto& entry : all_entries())
    add_once(names, entry.name);
  for (const auto& role : roles())
    for (const auto& alias : role.aliases)
      add_once(names, alias);
  for (const auto& entry : all_entries())
    for (const auto& detail : entry.details)
      add_once(names, name_of(entry, detail));
  return names;
}

// First what has the name; if nothing has it, what mentions the word.
Expected<std::string> reference_text(const std::string& name,
                                     const Lines& others) {
  std::string text;
  for (const auto& entry : entries_of(name))
    text += (text.empty() ? "" : "\n") + entry_text(entry);
  const auto* also = text.empty() ? "" : "also ";
  add_lines(text, "'" + name + "' " + also + "belongs to", holders_of(name));
  if (text.empty() && !name.empty())
    add_lines(text, "nothing is called '" + name + "'; it is spoken of in",
              mentions_of(name));
  if (!text.empty())
    return text;
  auto names = reference_names();
  names.insert(names.end(), others.begin(), others.end());
  return fail(ErrorKind::settings, "nothing is called '" + name + "'" +
                                       script::did_you_mean(name, names));
}

} // namespace parlour::tools
