// Training in two parts. A classifier learns which topic a text is about, with
// one more label for texts about none. A tagger learns which words fill slots.
// In both, words of a known value are replaced by its kind, so a few examples
// cover all values.
#include "adapters/nlu/understand/trained_model.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/grammar/marked_text.hpp"
#include "adapters/nlu/text/negation.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// The label of texts that are about no topic.
constexpr std::uint32_t nothing = 0;

// With fewer texts, too few can be held out to find the calibration.
constexpr std::size_t many_texts = 300;
// From so many on, the calibration alone tells what is about nothing.
constexpr std::size_t very_many_texts = 2000;
// Of the words, beside grammars.
constexpr float mostly_known = 0.5F;
// Words in one text without a topic.
constexpr std::size_t words_of_nothing = 20;
// From this probability on, the encoder is not asked.
constexpr float sure = 0.9F;
// Beside grammars, examples are few, and many sentences are about nothing that
// they are about: one is only taken for what it is like. Between these
// likenesses to the most similar example, probabilities go from 0 to 1.
constexpr float unlike = 0.45F;
constexpr float alike = 0.8F;
// One text in this many is held out for the calibration.
constexpr std::size_t one_in = 5;

// Whether a text is held out. Texts that differ in their values only, made from
// one template, are held out together: a text whose like was learnt tells
// nothing of those that people will say.
bool held_out(const std::vector<Feature>& features) {
  Feature sum = 0;
  for (const auto feature : features)
    if (class_of(feature) != FeatureClass::word_of_value)
      sum = (sum ^ feature) * 0x100000001b3;
  return (sum >> 32) % one_in == 0;
}

// Whether the span is a known value, without titles and determiners before it.
// Words that only sound or look like one are no evidence: in "how can I root a
// phone", nobody is called Ruth.
bool is_certain(const Span& span) {
  return (is_form(span.entity) || is_set(span.entity)) && !span.weak &&
         !span.unmatched && span.confidence >= guessed_value &&
         span.begin == span.core;
}

// For the encoder.
std::string text_of(const std::vector<LearningWord>& words) {
  std::string text;
  for (const auto& word : words)
    if (!word.filler)
      text.append(text.empty() ? "" : " ").append(word.word);
  return text;
}

// Whether there are rules that are neither examples nor the platform's.
bool has_grammars(const Automaton& automaton) {
  return std::ranges::any_of(automaton.rules, [](const RuleInfo& rule) {
    return !rule.generic && !rule.bare && !rule.grammar.empty();
  });
}

} // namespace

std::vector<LearningWord> TrainedModel::words(const Utterance& utterance,
                                              const Spans& spans) const {
  std::vector<LearningWord> words;
  const auto* vectors = language_.vectors.get();
  for (std::size_t at = 0; at < utterance.size(); ++at) {
    const auto& word = utterance.tokens.list[at].word;
    words.push_back({word, 0, vectors ? vectors->find(word) : WordMeaning(),
                     utterance.filler[at]});
  }
  std::vector<const Span*> known;
  for (const auto& span : spans.all())
    if (is_certain(span))
      known.push_back(&span);
  // Longer values first, so that a value within a longer one does not count.
  std::ranges::stable_sort(known, [](const Span* left, const Span* right) {
    return left->end - left->begin > right->end - right->begin;
  });
  for (const auto* span : known) {
    const auto part =
        std::span(words).subspan(span->begin, span->end - span->begin);
    if (std::ranges::all_of(part,
                            [](const auto& one) { return one.kind == 0; }))
      for (auto& word : part)
        word.kind = span->entity + 1;
  }
  return words;
}

// Collects the examples in the form that classifier and tagger need, then
// trains both.
class Trainer {
public:
  Trainer(TrainedModel& learned, const Schema& schema,
          const Automaton& automaton, LearningLimits limits)
      : learned_(learned), schema_(schema), automaton_(automaton),
        limits_(limits) {
    learned_.slots_of_.resize(schema.topics().size());
  }

  // Adds the examples of a topic. Each call takes the next label.
  Expected<void> add(const TopicModel& topic) {
    if (topic.examples.empty())
      return {};
    learned_.topics_.push_back(schema_.topic(topic.name));
    learned_.negates_.push_back(false);
    const auto& slots = schema_.at(learned_.topics_.back()).slots;
    learned_.takes_any_words_.push_back(std::ranges::any_of(
        slots, [](const auto& slot) { return slot.entity == words_entity; }));
    for (const auto& example : topic.examples)
      if (const auto marked = read_marks(example)) {
        add(*marked);
        if (features_ > limits_.features)
          return fail(ErrorKind::limit,
                      "the examples are too many to be learnt: there is room "
                      "for the first " +
                          std::to_string(texts_.size() - 1) +
                          "; leave out some, of those that say the same");
      }
    return {};
  }

  Expected<void> learn(double threshold) {
    if (learned_.topics_.empty())
      return {};
    number_slots();
    add_nothing();
    return learn_topics(threshold).and_then([this] { return learn_slots(); });
  }

private:
  // The classifiers are trained on all texts; the calibration is found with
  // further ones.
  Expected<void> learn_topics(double threshold) {
    const auto labels = static_cast<std::uint32_t>(learned_.topics_.size() + 1);
    auto classifier = Classifier::train(texts_, labels, limits_.weights);
    if (!classifier)
      return fail(ErrorKind::limit,
                  "the examples of " + std::to_string(labels - 1) +
                      " topics are too many to be learnt; leave out examples, "
                      "or write one topic for several");
    learned_.by_words_.classifier = std::move(*classifier);
    if (learned_.language_.encoder && texts_.size() <= limits_.sentences)
      learn_sentences(labels);
    if (texts_.size() >= many_texts)
      settle(labels, threshold);
    // Frees the memory before the tagger needs it.
    texts_ = {};
    return {};
  }

  void learn_sentences(std::uint32_t labels) {
    for (std::size_t at = 0; at < texts_.size(); ++at)
      texts_[at].features.sentence =
          learned_.language_.encoder->remember(said_[at]);
    if (learned_.beside_grammars_)
      for (const auto& text : texts_)
        learned_.nearest_.add(text.features.sentence, text.label);
    auto classifier =
        Classifier::train(texts_, labels, limits_.weights, Evidence::sentences);
    if (classifier)
      learned_.by_sentences_ = {{std::move(*classifier)}};
  }

  // A text may only have the slots of its topic.
  Expected<void> learn_slots() {
    for (std::size_t at = 0; at < tagged_.size(); ++at)
      tagged_[at].slots = learned_.slots_of_[tagged_topics_[at]];
    const auto slots = static_cast<std::uint32_t>(learned_.slots_.size());
    auto tagger = Tagger::train(tagged_, slots, limits_.weights);
    if (!tagger)
      return fail(ErrorKind::limit,
                  "the examples of " + std::to_string(slots) +
                      " slots are too many to be learnt; leave out examples, "
                      "or write one slot for several");
    learned_.tagger_ = std::move(*tagger);
    return {};
  }

  // An example's text with its values found.
  struct Read {
    Read(std::string_view text, const Schema& schema,
         const Automaton& automaton, const TrainedModel& learned)
        : utterance(make_utterance(text, automaton)),
          spans(schema, utterance, automaton.entities, Timestamp{0}),
          words(learned.words(utterance, spans)) {}

    Utterance utterance;
    Spans spans;
    std::vector<LearningWord> words;
  };

  void add(const MarkedText& marked) {
    const Read read(marked.text, schema_, automaton_, learned_);
    if (is_negated_order(read.utterance.tokens, read.utterance.negates))
      learned_.negates_.back() = true;
    add(read.words, static_cast<std::uint32_t>(learned_.topics_.size()));
    features_ += texts_.back().features.features.size();
    const auto topic = learned_.topics_.back();
    if (schema_.at(topic).slots.empty())
      return;
    tagged_.push_back({word_features(read.words), labels(marked, read), {}});
    tagged_topics_.push_back(topic);
    for (const auto& word : tagged_.back().features)
      features_ += word.size();
  }

  // Labels the tokens that overlap with a mark.
  std::vector<TagLabel> labels(const MarkedText& marked, const Read& read) {
    const auto& tokens = read.utterance.tokens.list;
    std::vector<TagLabel> made(tokens.size(), outside);
    for (const auto& mark : marked.marks) {
      const auto slot = slot_number(mark.slot);
      bool first = true;
      for (std::size_t at = 0; at < tokens.size(); ++at) {
        if (tokens[at].begin >= mark.end || tokens[at].end <= mark.begin)
          continue;
        made[at] = first ? begins(slot) : goes_on(slot);
        first = false;
      }
    }
    return made;
  }

  // Slots of the same name in several topics are one slot for the tagger.
  std::uint32_t slot_number(const std::string& slot) {
    auto& slots = learned_.slots_;
    const auto found = std::ranges::find(slots, slot);
    const auto number = static_cast<std::uint32_t>(found - slots.begin());
    if (found == slots.end())
      slots.push_back(slot);
    return number;
  }

  // Lists for each topic those slots that it has.
  void number_slots() {
    for (const auto topic : learned_.topics_)
      for (std::uint32_t slot = 0; slot < learned_.slots_.size(); ++slot)
        if (schema_.at(topic).find(learned_.slots_[slot]))
          learned_.slots_of_[topic].push_back(slot);
  }

  // Function words and fillers are examples of no topic. Each text has many of
  // them, so that a few in an utterance do not outweigh its other words.
  void add_nothing() {
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

  void add_nothing(const std::string& text) {
    add(Read(text, schema_, automaton_, learned_).words, nothing);
  }

  void add(const std::vector<LearningWord>& words, std::uint32_t label) {
    texts_.push_back({text_features(words), label});
    if (learned_.language_.encoder && said_.size() <= limits_.sentences)
      said_.push_back(text_of(words));
  }

  // Trains classifiers without the texts that are held out. Moves the texts, so
  // that none is in memory twice.
  void settle(std::uint32_t labels, double threshold) {
    std::vector<LabelledText> learnt;
    std::vector<LabelledText> others;
    for (auto& text : texts_) {
      const bool out =
          held_out(text.features.features) && text.label != nothing;
      (out ? others : learnt).push_back(std::move(text));
    }
    const auto certainty = [&](Evidence evidence) {
      const auto trial = Classifier::train(learnt, labels, no_limit, evidence);
      std::vector<HeldOutText> read;
      for (const auto& text : others)
        read.push_back({trial->read(text.features), text.label});
      return Certainty(read, threshold);
    };
    learned_.by_words_.certainty = certainty(Evidence::words);
    if (learned_.by_sentences_)
      learned_.by_sentences_->certainty = certainty(Evidence::sentences);
    learned_.least_known_ = 0;
    if (learnt.size() + others.size() >= very_many_texts)
      learned_.mostly_known_ = 0;
  }

  TrainedModel& learned_;
  const Schema& schema_;
  const Automaton& automaton_;
  const LearningLimits limits_;
  std::size_t features_ = 0; // of all examples so far
  std::vector<LabelledText> texts_;
  // What the texts are, for the encoder.
  std::vector<std::string> said_;
  std::vector<TaggedText> tagged_;
  std::vector<TopicNumber> tagged_topics_;
};

Expected<TrainedModel>
TrainedModel::train(const std::vector<TopicModel>& topics, const Schema& schema,
                    const Automaton& automaton, double threshold,
                    LearningLimits limits, LanguageKnowledge language) {
  TrainedModel learned;
  learned.language_ = std::move(language);
  learned.beside_grammars_ = has_grammars(automaton);
  if (learned.beside_grammars_)
    learned.mostly_known_ = mostly_known;
  Trainer trainer(learned, schema, automaton, limits);
  for (const auto& topic : topics)
    if (auto added = trainer.add(topic); !added)
      return tl::make_unexpected(added.error());
  if (auto learnt = trainer.learn(threshold); !learnt)
    return tl::make_unexpected(learnt.error());
  return learned;
}

// The encoder is slow, so it is asked only if the words leave something open.
// It also tells that a sentence is about something else in the same words.
std::vector<float>
TrainedModel::probabilities(const TextReading& reading,
                            const std::vector<LearningWord>& words,
                            TextFeatures features) const {
  auto made = by_words_.certainty.probabilities(reading);
  if (!by_sentences_ || *std::ranges::max_element(made) >= sure)
    return made;
  features.sentence = language_.encoder->encode(text_of(words));
  made = by_sentences_->certainty.probabilities(
      by_sentences_->classifier.read(features));
  if (!beside_grammars_)
    return made;
  const auto likeness = nearest_.find(features.sentence, made.size());
  for (std::size_t at = 0; at < made.size(); ++at)
    made[at] = std::min(
        made[at], std::max(0.0F, (likeness[at] - unlike) / (alike - unlike)));
  return made;
}

std::vector<TopicHypothesis>
TrainedModel::topics(const std::vector<LearningWord>& words) const {
  auto features = text_features(words);
  const auto reading = by_words_.classifier.read(features);
  if (reading.known < least_known_)
    return {};
  const bool is_mostly_new = reading.known < mostly_known_;
  const auto probabilities =
      this->probabilities(reading, words, std::move(features));
  std::vector<TopicHypothesis> made;
  for (std::size_t at = 0; at < topics_.size(); ++at)
    if (!is_mostly_new || takes_any_words_[at])
      made.push_back({topics_[at], probabilities[at + 1], negates_[at]});
  std::ranges::stable_sort(made, std::greater(), &TopicHypothesis::probability);
  return made;
}

std::vector<SlotHypothesis>
TrainedModel::slots(TopicNumber topic,
                    const std::vector<std::vector<Feature>>& features) const {
  const auto labels = tagger_.tag(features, slots_of_[topic]);
  std::vector<SlotHypothesis> made;
  for (std::uint32_t at = 0; at < labels.size(); ++at) {
    if (labels[at] == outside)
      continue;
    // A continuation follows its beginning, so there is always an entry to
    // extend.
    if (is_beginning(labels[at]))
      made.push_back({slots_[slot_of(labels[at])], at, at});
    made.back().end = at + 1;
  }
  return made;
}

} // namespace parlour::adapters::nlu
