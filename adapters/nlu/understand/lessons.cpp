#include "adapters/nlu/understand/lessons.hpp"

#include <algorithm>
#include <set>

#include "adapters/nlu/text/negation.hpp"
#include "adapters/nlu/text/words.hpp"
#include "adapters/nlu/understand/learning_words.hpp"

namespace parlour::adapters::nlu {

namespace {

// So many wordings are many.
constexpr std::size_t many_wordings = 300;
// Of what rules say, so many sentences are learnt of each meaning that has
// wordings, and of all others together.
constexpr std::size_t sentences_of_meaning = 30;
constexpr std::size_t sentences_of_others = 600;
// Words in one text without a topic.
constexpr std::size_t words_of_nothing = 20;

bool have_equal_meaning(const LessonLabel& one, const LessonLabel& other) {
  return one.topic == other.topic && one.constants == other.constants &&
         one.needs == other.needs;
}

using Constants = decltype(LessonLabel::constants);

LessonLabel meaning_of(TopicNumber topic, const Constants& constants,
                       const std::set<std::string>& said) {
  return {topic, constants, {said.begin(), said.end()}};
}

LessonLabel meaning_of(const SampledSentence& sentence) {
  std::set<std::string> said;
  for (const auto& [slot, entity] : sentence.values)
    said.insert(slot);
  return meaning_of(sentence.meaning.topic, sentence.meaning.literals, said);
}

LessonLabel meaning_of(TopicNumber topic, const Constants& constants,
                       const MarkedText& marked) {
  std::set<std::string> said;
  for (const auto& mark : marked.marks)
    said.insert(mark.slot);
  return meaning_of(topic, constants, said);
}

LearningWord learning_word(const std::string& word) {
  if (const auto entity = kind_of_word(word))
    return {{}, *entity + 1};
  return {word};
}

bool overlap(const Token& token, const MarkedText::Mark& mark) {
  return token.begin < mark.end && token.end > mark.begin;
}

} // namespace

// A text with its values found.
struct Lessons::Read {
  Read(std::string_view text, const Lessons& lessons)
      : utterance(make_utterance(text, lessons.automaton_)),
        spans(lessons.schema_, utterance, lessons.automaton_.entities,
              Timestamp{0}),
        words(learning_words(utterance, spans, lessons.vectors_)) {}

  void mark(const MarkedText::Mark& mark, EntityId entity) {
    for (std::size_t at = 0; at < words.size(); ++at)
      if (overlap(utterance.tokens.list[at], mark))
        words[at].kind = entity + 1;
  }

  Utterance utterance;
  Spans spans;
  std::vector<LearningWord> words;
};

Lessons::Lessons(const Schema& schema, const Automaton& automaton,
                 const WordVectors* vectors, std::size_t max_features)
    : slots_of(schema.topics().size()), schema_(schema), automaton_(automaton),
      vectors_(vectors), max_features_(max_features) {}

Expected<void> Lessons::add(const TopicModel& topic) {
  const LessonLabel meaning{schema_.topic(topic.name), {}, {}};
  for (const auto& example : topic.examples)
    if (const auto marked = read_marks(example))
      if (auto added = add(meaning, *marked, false); !added)
        return added;
  return {};
}

Expected<void> Lessons::add(const FurtherLessons& further) {
  for (const auto& wording : further.wordings)
    if (const auto marked = read_marks(wording.text))
      if (auto added = add(meaning_of(schema_.topic(wording.topic),
                                      wording.constants, *marked),
                           *marked, true);
          !added)
        return added;
  are_many = further.wordings.size() >= many_wordings;
  if (!are_many)
    return {};
  add_rules(further.rules);
  for (const auto& sentence : further.other_talk)
    add_nothing(sentence);
  return {};
}

Expected<void> Lessons::add(const LessonLabel& meaning,
                            const MarkedText& marked, bool is_wording) {
  const auto number = label_of(meaning);
  Read read(marked.text, *this);
  auto& label = labels[number - 1];
  if (is_negated_order(read.utterance.tokens, read.utterance.negates))
    label.negates = true;
  if (calls_off(read.utterance.tokens))
    label.calls_off = true;
  const auto& topic = schema_.at(label.topic);
  for (const auto& mark : marked.marks)
    if (const auto* slot = topic.find(mark.slot);
        slot && is_known(slot->entity))
      read.mark(mark, slot->entity);
  add(read.words, number);
  features_ += texts.back().features.features.size();
  if (!topic.slots.empty() && !(is_wording && marked.marks.empty())) {
    tagged.push_back({word_features(read.words), tags(marked, read), {}});
    tagged_topics_.push_back(label.topic);
    for (const auto& word : tagged.back().features)
      features_ += word.size();
  }
  if (features_ <= max_features_)
    return {};
  return fail(ErrorKind::limit,
              "the examples are too many to be learnt: there is room for the "
              "first " +
                  std::to_string(texts.size() - 1) +
                  "; leave out some, of those that say the same");
}

void Lessons::add(const std::vector<LearningWord>& words, std::uint32_t label) {
  texts.push_back({text_features(words), label});
  said.push_back(text_of(words));
}

// Those of meanings without wordings become one label that tells no topic: they
// are left to the rules.
void Lessons::add_rules(std::span<const SampledSentence> sentences) {
  const auto all = labels.size();
  std::vector<std::size_t> counts(all + 1);
  for (const auto& sentence : sentences) {
    const auto meaning = meaning_of(sentence);
    const auto found = std::ranges::find_if(labels, [&](const auto& label) {
      return have_equal_meaning(label, meaning);
    });
    const auto at = static_cast<std::size_t>(found - labels.begin());
    if (counts[at]++ >= (at < all ? sentences_of_meaning : sentences_of_others))
      continue;
    std::vector<LearningWord> words;
    for (const auto& word : sentence.words)
      words.push_back(learning_word(word));
    add(words, static_cast<std::uint32_t>(at + 1));
  }
  if (counts.back() > 0)
    labels.emplace_back();
}

// Whether its values are looked for in texts.
bool Lessons::is_known(EntityId entity) const {
  return has_known_values(entity) &&
         std::ranges::find(automaton_.entities, entity) !=
             automaton_.entities.end();
}

// A new one if there is none.
std::uint32_t Lessons::label_of(const LessonLabel& meaning) {
  const auto found = std::ranges::find_if(labels, [&](const auto& label) {
    return have_equal_meaning(label, meaning);
  });
  const auto number = static_cast<std::uint32_t>(found - labels.begin() + 1);
  if (found == labels.end()) {
    labels.push_back(meaning);
    labels.back().takes_any_words = std::ranges::any_of(
        schema_.at(meaning.topic).slots,
        [](const auto& slot) { return slot.entity == words_entity; });
  }
  return number;
}

// Labels the tokens that overlap with a mark.
std::vector<TagLabel> Lessons::tags(const MarkedText& marked,
                                    const Read& read) {
  const auto& tokens = read.utterance.tokens.list;
  std::vector<TagLabel> made(tokens.size(), outside);
  for (const auto& mark : marked.marks) {
    const auto slot = slot_number(mark.slot);
    bool first = true;
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      if (!overlap(tokens[at], mark))
        continue;
      made[at] = first ? begins(slot) : goes_on(slot);
      first = false;
    }
  }
  return made;
}

// Slots of the same name in several topics are one slot for the tagger.
std::uint32_t Lessons::slot_number(const std::string& slot) {
  const auto found = std::ranges::find(slots, slot);
  const auto number = static_cast<std::uint32_t>(found - slots.begin());
  if (found == slots.end())
    slots.push_back(slot);
  return number;
}

void Lessons::number_slots() {
  for (const auto topic :
       std::set(tagged_topics_.begin(), tagged_topics_.end()))
    for (std::uint32_t slot = 0; slot < slots.size(); ++slot)
      if (schema_.at(topic).find(slots[slot]))
        slots_of[topic].push_back(slot);
  for (std::size_t at = 0; at < tagged.size(); ++at)
    tagged[at].slots = slots_of[tagged_topics_[at]];
}

void Lessons::add_nothing() {
  std::string text;
  std::size_t count = 0;
  for (const auto word : all_function_words()) {
    text.append(word).append(" ");
    if (++count % words_of_nothing == 0)
      add_nothing(std::exchange(text, ""));
  }
  for (const auto phrase : filler_phrases())
    text.append(phrase).append(" ");
  add_nothing(text);
}

void Lessons::add_nothing(const std::string& text) {
  add(Read(text, *this).words, label_of_nothing);
}

} // namespace parlour::adapters::nlu
