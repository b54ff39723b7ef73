// Training in two parts. A classifier learns which topic a text is about, with
// one more label for texts about none. A tagger learns which words fill slots.
// In both, words of a known value are replaced by its kind, so a few examples
// cover all values.
#include "adapters/nlu/understand/trained_model.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/encoder/known_sentences.hpp"
#include "adapters/nlu/understand/learning_words.hpp"

namespace parlour::adapters::nlu {

namespace {

// With fewer texts, too few can be held out to find the calibration.
constexpr std::size_t many_texts = 300;
// From so many on, the calibration alone tells what is about nothing.
constexpr std::size_t very_many_texts = 2000;
// Of the words, beside grammars.
constexpr float mostly_known = 0.5F;
// From this probability on, the encoder is not asked; nor of fewer words, which
// mean too much without others.
constexpr float sure = 0.9F;
constexpr std::size_t least_words = 3;
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

// Whether there are rules that are neither examples nor the platform's.
bool has_grammars(const Automaton& automaton) {
  return std::ranges::any_of(automaton.rules, [](const RuleInfo& rule) {
    return !rule.generic && !rule.bare && !rule.grammar.empty();
  });
}

} // namespace

std::vector<LearningWord> TrainedModel::words(const Utterance& utterance,
                                              const Spans& spans) const {
  return learning_words(utterance, spans, language_.vectors.get());
}

// Trains classifier and tagger on what the lessons have collected, which it
// takes from them piece by piece, so that nothing is in memory twice.
class Trainer {
public:
  Trainer(TrainedModel& learned, Lessons& lessons, LearningLimits limits)
      : learned_(learned), lessons_(lessons), limits_(limits) {}

  Expected<void> learn(double threshold) {
    if (lessons_.labels.empty())
      return {};
    lessons_.number_slots();
    lessons_.add_nothing();
    learned_.labels_ = std::move(lessons_.labels);
    learned_.is_well_taught_ = lessons_.are_many;
    return learn_topics(threshold).and_then([this] { return learn_slots(); });
  }

private:
  // The classifiers are trained on all texts; the calibration is found with
  // further ones.
  Expected<void> learn_topics(double threshold) {
    auto& texts = lessons_.texts;
    const auto labels = static_cast<std::uint32_t>(learned_.labels_.size() + 1);
    auto classifier = Classifier::train(texts, labels, limits_.weights);
    if (!classifier)
      return fail(ErrorKind::limit,
                  "the examples of " + std::to_string(labels - 1) +
                      " meanings are too many to be learnt; leave out "
                      "examples, or write one topic for several");
    learned_.by_words_.classifier = std::move(*classifier);
    if (reads_sentences())
      learn_sentences(labels);
    if (lessons_.are_many)
      trust_many();
    else if (texts.size() >= many_texts)
      settle(labels, threshold);
    // Frees the memory before the tagger needs it.
    texts = {};
    return {};
  }

  bool reads_sentences() const {
    const auto& language = learned_.language_;
    const auto most = language.known_sentences.empty()
                          ? limits_.sentences
                          : limits_.known_sentences;
    return language.encoder && lessons_.texts.size() <= most;
  }

  void learn_sentences(std::uint32_t labels) {
    auto& texts = lessons_.texts;
    const auto& language = learned_.language_;
    auto sentences =
        encode_all(lessons_.said, *language.encoder, language.known_sentences);
    for (std::size_t at = 0; at < texts.size(); ++at)
      texts[at].features.sentence = std::move(sentences[at]);
    if (learned_.beside_grammars_ && !lessons_.are_many)
      for (const auto& text : texts)
        learned_.nearest_.add(text.features.sentence, text.label);
    auto classifier =
        Classifier::train(texts, labels, limits_.weights, Evidence::sentences);
    if (classifier)
      learned_.by_sentences_ = {{std::move(*classifier)}};
  }

  // Other talk was learnt, too: it tells what is about nothing.
  void trust_many() {
    learned_.by_words_.certainty = Certainty::of_many(Evidence::words);
    if (learned_.by_sentences_)
      learned_.by_sentences_->certainty =
          Certainty::of_many(Evidence::sentences);
  }

  // A text may only have the slots of its topic.
  Expected<void> learn_slots() {
    const auto slots = static_cast<std::uint32_t>(lessons_.slots.size());
    auto tagger = Tagger::train(lessons_.tagged, slots, limits_.weights);
    if (!tagger)
      return fail(ErrorKind::limit,
                  "the examples of " + std::to_string(slots) +
                      " slots are too many to be learnt; leave out examples, "
                      "or write one slot for several");
    learned_.tagger_ = std::move(*tagger);
    learned_.slots_ = std::move(lessons_.slots);
    learned_.slots_of_ = std::move(lessons_.slots_of);
    return {};
  }

  // Trains classifiers without the texts that are held out. Moves the texts, so
  // that none is in memory twice.
  void settle(std::uint32_t labels, double threshold) {
    std::vector<LabelledText> learnt;
    std::vector<LabelledText> others;
    for (auto& text : lessons_.texts) {
      const bool out =
          held_out(text.features.features) && text.label != label_of_nothing;
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
  Lessons& lessons_;
  const LearningLimits limits_;
};

Expected<TrainedModel>
TrainedModel::train(const std::vector<TopicModel>& topics, const Schema& schema,
                    const Automaton& automaton, double threshold,
                    LearningLimits limits, LanguageKnowledge language,
                    FurtherLessons further) {
  TrainedModel learned;
  learned.language_ = std::move(language);
  learned.beside_grammars_ = has_grammars(automaton);
  if (learned.beside_grammars_)
    learned.mostly_known_ = mostly_known;
  Lessons lessons(schema, automaton, learned.language_.vectors.get(),
                  limits.features);
  for (const auto& topic : topics)
    if (auto added = lessons.add(topic); !added)
      return tl::make_unexpected(added.error());
  if (auto added = lessons.add(further); !added)
    return tl::make_unexpected(added.error());
  if (auto learnt = Trainer(learned, lessons, limits).learn(threshold); !learnt)
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
  if (!by_sentences_ || *std::ranges::max_element(made) >= sure ||
      words.size() < least_words)
    return made;
  features.sentence = language_.encoder->encode(text_of(words));
  made = by_sentences_->certainty.probabilities(
      by_sentences_->classifier.read(features));
  if (!beside_grammars_ || is_well_taught_)
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
  for (std::size_t at = 0; at < labels_.size(); ++at)
    if (const auto& label = labels_[at];
        label.topic != no_topic && (!is_mostly_new || label.takes_any_words))
      made.push_back({label.topic, probabilities[at + 1], &label});
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
