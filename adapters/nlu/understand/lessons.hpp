// Lessons collects what an application's understanding learns: texts, what each
// means, and which of its words fill slots. Meanings are labels from 1 on;
// label 0 is that of texts about no topic.
//
//  Lessons lessons(schema, automaton, vectors);
//  if (auto added = lessons.add(topic, limits); !added) …
//  lessons.add_nothing();
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "adapters/nlu/grammar/automaton.hpp"
#include "adapters/nlu/grammar/example_file.hpp"
#include "adapters/nlu/grammar/marked_text.hpp"
#include "adapters/nlu/grammar/sampled_sentences.hpp"
#include "adapters/nlu/learning/classifier.hpp"
#include "adapters/nlu/learning/tagger.hpp"
#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

// The label of texts that are about no topic.
inline constexpr std::uint32_t label_of_nothing = 0;

// What texts with a label mean.
struct LessonLabel {
  TopicNumber topic = no_topic; // none: what is left to the rules
  // Slots that are filled though their values are not said.
  std::vector<std::pair<std::string, Value>> constants;
  // Slots that all of its wordings say, in the order of their names.
  std::vector<std::string> needs;
  bool negates = false;         // some of its texts are negated orders
  bool calls_off = false;       // some of its texts call something off
  bool takes_any_words = false; // a slot of the topic does
};

// What is learnt beside examples.
struct FurtherLessons {
  std::span<const Wording> wordings = {};
  // What the rules say.
  std::span<const SampledSentence> rules = {};
  // Sentences that are about nothing of any application.
  std::span<const std::string> other_talk = {};
};

// For one thread. What it refers to must outlive it.
class Lessons {
public:
  // `vectors` may be null. More features than these of all examples and
  // wordings together are an error of kind Limit.
  Lessons(const Schema& schema, const Automaton& automaton,
          const WordVectors* vectors, std::size_t max_features);

  // The examples of a topic. Those whose marks do not fit are left out.
  Expected<void> add(const TopicModel& topic);
  // What rules say and other talk are only learnt beside many wordings: among
  // so much else, few would not be seen.
  Expected<void> add(const FurtherLessons& further);
  // Function words and fillers, as texts about no topic. Each text has many of
  // them, so that a few in an utterance do not outweigh its other words.
  void add_nothing();
  // Gives each text the slots that it may have; call it behind all texts.
  void number_slots();

  // By label - 1.
  std::vector<LessonLabel> labels;
  std::vector<LabelledText> texts;
  std::vector<std::string> said; // what the texts are, for the encoder
  std::vector<TaggedText> tagged;
  std::vector<std::string> slots; // as the tagger numbers them
  // By topic: its slots.
  std::vector<std::vector<std::uint32_t>> slots_of;
  // Whether other talk was learnt, and much of what people say.
  bool are_many = false;

private:
  struct Read;

  // Of wordings, the tagger learns those alone that have marks: the others are
  // many, and say nothing of slots.
  Expected<void> add(const LessonLabel& meaning, const MarkedText& marked,
                     bool is_wording);
  void add(const std::vector<LearningWord>& words, std::uint32_t label);
  void add_rules(std::span<const SampledSentence> sentences);
  void add_nothing(const std::string& text);
  bool is_known(EntityId entity) const;
  std::uint32_t label_of(const LessonLabel& meaning);
  std::uint32_t slot_number(const std::string& slot);
  std::vector<TagLabel> tags(const MarkedText& marked, const Read& read);

  const Schema& schema_;
  const Automaton& automaton_;
  const WordVectors* vectors_;
  const std::size_t max_features_;
  std::size_t features_ = 0; // of examples and wordings so far
  std::vector<TopicNumber> tagged_topics_;
};

} // namespace parlour::adapters::nlu
