// TrainedModel is what is learnt from the examples of an application when it is
// loaded: which topic an utterance is about, and which words fill its slots
// (understanding, "Examples").
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adapters/nlu/encoder/nearest_sentences.hpp"
#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/learning/certainty.hpp"
#include "adapters/nlu/learning/classifier.hpp"
#include "adapters/nlu/learning/tagger.hpp"
#include "adapters/nlu/parse/spans.hpp"
#include "adapters/nlu/understand/language_knowledge.hpp"
#include "adapters/nlu/understand/lessons.hpp"
#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

struct TopicHypothesis {
  TopicNumber topic = no_topic;
  double probability = 0;
  // What else it means; of the model.
  const LessonLabel* label = nullptr;
};

struct SlotHypothesis {
  std::string slot;
  // Tokens [begin, end).
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

// How much memory learning may use. An application that needs more cannot be
// trained.
struct LearningLimits {
  // The features of all examples together; each takes eight bytes.
  std::size_t features = 8 << 20;
  // The weights of the classifier, and those of the tagger; each takes four
  // bytes.
  std::size_t weights = 16 << 20;
  // Texts that the encoder reads, at some milliseconds each, where nothing is
  // kept of what it makes of them. Of more, the words alone tell enough.
  std::size_t sentences = 2000;
  // The same where it is kept.
  std::size_t known_sentences = 20'000;
};

// Immutable; any number of threads may use it.
class TrainedModel {
public:
  // Trains classifier and tagger. Examples whose marks do not fit are left out.
  // With many examples, probabilities are calibrated by texts that are held
  // out, so that those which are told right reach `threshold`. The error, of
  // kind Limit, says what there is too much of.
  static Expected<TrainedModel>
  train(const std::vector<TopicModel>& topics, const Schema& schema,
        const Automaton& automaton, double threshold,
        LearningLimits limits = {}, LanguageKnowledge language = {},
        FurtherLessons further = {});

  // The words of an utterance as the model sees them: those of a known value
  // have its kind. They refer to the utterance and the model.
  std::vector<LearningWord> words(const Utterance& utterance,
                                  const Spans& spans) const;

  // The topics with examples, and what wordings mean of them, the most likely
  // first. What is missing to 1 is the probability that the utterance is about
  // none of them. Empty if examples have hardly any of the words: then only the
  // frequency of the topics would speak.
  std::vector<TopicHypothesis>
  topics(const std::vector<LearningWord>& words) const;

  // The words that fill slots of the topic, in their order. `features` is the
  // result of word_features().
  std::vector<SlotHypothesis>
  slots(TopicNumber topic,
        const std::vector<std::vector<Feature>>& features) const;

  bool empty() const {
    return labels_.empty();
  }
  // Whether it was taught by many wordings, and by talk about something else:
  // then it may know better than a doubtful reading of the grammars.
  bool is_well_taught() const {
    return is_well_taught_;
  }
  // Whether the application has grammars, so that examples are not all that it
  // understands by.
  bool is_beside_grammars() const {
    return beside_grammars_;
  }

private:
  friend class Trainer;

  // A classifier, and how sure what it says is.
  struct TopicReader {
    Classifier classifier;
    Certainty certainty = {};
  };

  std::vector<float> probabilities(const TextReading& reading,
                                   const std::vector<LearningWord>& words,
                                   TextFeatures features) const;

  std::vector<LessonLabel> labels_;
  std::vector<std::string> slots_;
  // By topic: its slots, as numbers of the tagger.
  std::vector<std::vector<std::uint32_t>> slots_of_;
  LanguageKnowledge language_;
  TopicReader by_words_;
  // None without an encoder.
  std::optional<TopicReader> by_sentences_;
  NearestSentences nearest_; // beside grammars, if it is not well taught
  Tagger tagger_;
  // The least share of an utterance that examples must have, if there are too
  // few of them for more. A few letters in common ("foo" and "for") stay below
  // it; another form of a word ("renting" for "rent") is above.
  float least_known_ = 0.3F;
  // The same for a topic none of whose slots takes any words, beside grammars
  // and unless there are very many examples: of words that are mostly new to
  // both, the topic that is least unlikely tells nothing.
  float mostly_known_ = 0;
  bool beside_grammars_ = false;
  bool is_well_taught_ = false;
};

} // namespace parlour::adapters::nlu
