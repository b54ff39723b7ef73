#include "adapters/asr/words/value_sets.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "adapters/asr/words/spoken_words.hpp"

namespace parlour::adapters::asr {

namespace {

constexpr std::array<std::string_view, 7> forms{
    "time", "date", "number", "duration", "phone", "email", "level"};

// Bounds a set; the rest of a larger table is not heard.
constexpr std::size_t most_values = 5'000;

std::string lower(std::string_view text) {
  std::string made(text);
  std::ranges::transform(made, made.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return made;
}

// Words as they are written, without punctuation around them.
std::vector<std::string> written_words(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const auto c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalpha(byte) || byte >= 0x80 || (c == '\'' && !word.empty()))
      word += c;
    else if (!word.empty())
      words.push_back(std::exchange(word, {}));
  }
  if (!word.empty())
    words.push_back(std::move(word));
  return words;
}

const SlotModel* find_slot(const UnderstandingModel& model,
                           std::string_view name, const TopicModel*& of) {
  const auto point = name.find('.');
  for (const auto& topic : model.topics)
    for (const auto& slot : topic.slots)
      if (topic.name == name.substr(0, point) &&
          slot.name == name.substr(point + 1)) {
        of = &topic;
        return &slot;
      }
  return nullptr;
}

} // namespace

// "Will" as a name and "will" in a sentence: the small one wins.
void Spellings::note(std::string_view text, bool is_sentence) {
  bool is_first = true;
  for (auto& word : written_words(text)) {
    const bool tells = !(is_sentence && std::exchange(is_first, false));
    if (!tells)
      continue;
    auto& spelling = spellings_[lower(word)];
    if (lower(word) == word)
      spelling.small = true;
    else if (spelling.written.empty())
      spelling.written = std::move(word);
  }
}

std::string Spellings::written(const std::string& word) const {
  if (word == "i" || word.starts_with("i'"))
    return "I" + word.substr(1);
  if (word == "a.m." || word == "p.m.")
    return word == "a.m." ? "am" : "pm";
  const auto found = spellings_.find(word);
  return found == spellings_.end() || found->second.small ||
                 found->second.written.empty()
             ? word
             : found->second.written;
}

ValueSets::ValueSets(const UnderstandingModel& model, ColumnReader columns,
                     Symbols& symbols, Spellings& spellings)
    : model_(model), columns_(std::move(columns)), symbols_(symbols),
      spellings_(spellings) {}

Symbol ValueSets::form(std::string_view name) {
  const auto set = symbols_.value_set(name);
  builders_[set];
  return set;
}

Symbol ValueSets::open_set(std::string_view slot) {
  const auto set = symbols_.value_set("words:" + std::string(slot));
  builders_[set];
  return set;
}

// In this order: a column, a form, a slot; anything else stands for any words.
Symbol ValueSets::set_of(std::string_view reference, std::string_view slot) {
  if (reference.starts_with("db:"))
    return column(std::string(reference));
  if (std::ranges::find(forms, reference) != forms.end())
    return form(reference);
  const TopicModel* topic = nullptr;
  if (const auto* found = find_slot(model_, reference, topic))
    return set_of(*topic, *found);
  return open_set(slot);
}

// The order is that of the understanding: a slot with values may have a type,
// too.
Symbol ValueSets::set_of(const TopicModel& topic, const SlotModel& slot) {
  if (!slot.values.empty()) {
    const auto name = topic.name + "." + slot.name;
    const auto set = symbols_.value_set(name);
    if (!values_.contains(set))
      for (const auto& value : slot.values)
        add(set, value);
    return set;
  }
  if (!slot.source.empty())
    return column(slot.source);
  if (slot.type == "range")
    return form("number");
  if (std::ranges::find(forms, slot.type) != forms.end())
    return form(slot.type);
  return open_set(slot.name);
}

// A column that cannot be read is an empty set; it is not asked for again.
Symbol ValueSets::column(const std::string& name) {
  if (const auto found = read_columns_.find(name); found != read_columns_.end())
    return found->second;
  const auto set = symbols_.value_set(name);
  builders_[set];
  read_columns_[name] = set;
  const auto values =
      columns_ ? columns_(name) : fail(ErrorKind::database, "no database");
  if (!values)
    errors_.push_back(values.error());
  else
    for (const auto& value : *values)
      add(set, value);
  return set;
}

// A value that is said like another one counts once.
void ValueSets::add(Symbol set, std::string_view value) {
  auto& values = values_[set];
  auto& builder = builders_[set];
  if (values.size() >= most_values)
    return;
  std::vector<Symbol> words;
  for (const auto& word : spoken_words(value))
    words.push_back(symbols_.word(word));
  if (words.empty() || std::ranges::find(values, words) != values.end())
    return;
  builder.add_sentence(words);
  values.push_back(std::move(words));
  spellings_.note(value, false);
}

const std::vector<std::vector<Symbol>>& ValueSets::values(Symbol set) const {
  static const std::vector<std::vector<Symbol>> none;
  const auto found = values_.find(set);
  return found == values_.end() ? none : found->second;
}

std::map<Symbol, WordGraph> ValueSets::graphs() const {
  std::map<Symbol, WordGraph> graphs;
  for (const auto& [set, builder] : builders_)
    graphs.emplace(set, builder.finish());
  return graphs;
}

} // namespace parlour::adapters::asr
