#include "adapters/asr/moonshine_words.hpp"

#include <algorithm>
#include <cctype>
#include <unordered_set>
#include <utility>

#include "runtime/text/words.hpp"

namespace parlour::adapters::moonshine {

namespace {

// In characters; longer values are texts to be read, not to be said.
constexpr std::size_t longest_phrase = 80;
constexpr std::size_t most_phrases = 20'000;
// In characters. Shorter words of sentences are said everywhere, so to prefer
// them says nothing; shorter parts of names are met within other words.
constexpr std::size_t shortest_word = 5;
constexpr std::size_t shortest_name = 3;

// Keeps the order in which they come: the most important first.
class Phrases {
public:
  void add(std::string phrase) {
    if (!phrase.empty() && phrase.size() <= longest_phrase &&
        phrases_.size() < most_phrases && seen_.insert(phrase).second)
      phrases_.push_back(std::move(phrase));
  }
  void add(const std::vector<std::string>& phrases) {
    for (const auto& phrase : phrases)
      add(phrase);
  }
  std::size_t size() const {
    return phrases_.size();
  }
  std::vector<std::string> take() {
    return std::move(phrases_);
  }

private:
  std::vector<std::string> phrases_;
  std::unordered_set<std::string> seen_;
};

// People are called by a part of their name as well.
void add_values(Phrases& phrases, const std::vector<std::string>& values) {
  phrases.add(values);
  for (const auto& value : values)
    for (auto& word : split_words(value))
      if (word.size() >= shortest_name &&
          std::isupper(static_cast<unsigned char>(word.front())))
        phrases.add(std::move(word));
}

void add_slot(Phrases& phrases, const SlotModel& slot,
              const ColumnReader& columns) {
  add_values(phrases, slot.values);
  if (slot.source.empty())
    return;
  if (const auto values = columns(slot.source))
    add_values(phrases, *values);
}

// A single short word is left out, a run of short words is not.
void add_sentences(Phrases& phrases, std::vector<std::string> parts) {
  for (auto& part : parts)
    if (part.size() >= shortest_word || part.find(' ') != std::string::npos)
      phrases.add(std::move(part));
}

// Skips from `at` to behind `end`, or to the end of the text.
std::size_t behind(const std::string& text, std::size_t at,
                   std::string_view end) {
  const auto found = text.find(end, at);
  return found == std::string::npos ? text.size() : found + end.size();
}

bool is_word_character(char one) {
  return std::isalnum(static_cast<unsigned char>(one)) || one == '\'' ||
         static_cast<unsigned char>(one) >= 0x80;
}

// Where a part of a grammar that nobody speaks ends; `at` itself where none
// begins there.
std::size_t behind_unspoken(const std::string& text, std::size_t at) {
  const std::string_view rest = std::string_view(text).substr(at);
  if (rest.starts_with("//"))
    return behind(text, at, "\n");
  if (rest.starts_with("/*"))
    return behind(text, at + 2, "*/");
  switch (rest.front()) {
  case '<':
    return behind(text, at, ">");
  case '{':
    return behind(text, at, "}");
  case '/': // a weight, unless it stands within a word
    return at > 0 && is_word_character(text[at - 1])
               ? at
               : behind(text, at + 1, "/");
  case '@':
    return text.find_first_of(" \t\n;|()[]{}", at);
  default:
    return at;
  }
}

// Where the rules begin: behind the header and the grammar's name.
std::size_t first_rule(const std::string& jsgf) {
  const auto name = jsgf.find("grammar ");
  return name == std::string::npos ? 0 : behind(jsgf, name, ";");
}

} // namespace

// "<ask> = where is [the] @Place {act=request};" gives "where is" and "the": no
// parser is needed for that, and a grammar with a mistake gives words, too.
std::vector<std::string> grammar_words(const std::string& jsgf) {
  Phrases phrases;
  std::string run;
  for (auto at = first_rule(jsgf); at < jsgf.size();) {
    const auto next = behind_unspoken(jsgf, at);
    if (next == at && is_word_character(jsgf[at])) {
      run += jsgf[at++];
      continue;
    }
    if (next == at && jsgf[at] == ' ' && !run.empty() && run.back() != ' ') {
      run += jsgf[at++];
      continue;
    }
    while (!run.empty() && run.back() == ' ')
      run.pop_back();
    if (run != "public")
      phrases.add(std::exchange(run, {}));
    run.clear();
    at = next == at ? at + 1 : std::min(next, jsgf.size());
  }
  return phrases.take();
}

// What stands in brackets is one part, and the parenthesis behind it is not
// spoken.
std::vector<std::string> example_words(const std::string& example) {
  Phrases phrases;
  std::string part;
  const auto end_part = [&] {
    constexpr auto around = " ,.;:?!";
    const auto first = part.find_first_not_of(around);
    if (first != std::string::npos)
      phrases.add(
          part.substr(first, part.find_last_not_of(around) + 1 - first));
    part.clear();
  };
  for (std::size_t at = 0; at < example.size(); ++at)
    if (example[at] != '[' && example[at] != ']') {
      part += example[at];
    } else {
      end_part();
      if (example.compare(at, 2, "](") == 0)
        at = behind(example, at, ")") - 1;
    }
  end_part();
  return phrases.take();
}

Words application_words(const PluginHost& host, const ColumnReader& columns) {
  Words words;
  Phrases phrases;
  const auto model = host.understanding();
  if (!model)
    return {};
  for (const auto& topic : model->topics)
    for (const auto& slot : topic.slots)
      add_slot(phrases, slot, columns);
  words.names = phrases.size();
  for (const auto& grammar : model->grammars)
    add_sentences(phrases, grammar_words(grammar.text));
  for (const auto& topic : model->topics)
    for (const auto& example : topic.examples)
      add_sentences(phrases, example_words(example));
  words.phrases = phrases.take();
  return words;
}

} // namespace parlour::adapters::moonshine
