// What is learnt from the examples of an application's topics when it is
// loaded: which topic an utterance is about, and which words fill its slots
// (understanding, "Examples"). Immutable; any number of threads may ask it.
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/learning/classifier.hpp"
#include "adapters/nlu/learning/tagger.hpp"
#include "adapters/nlu/parse/spans.hpp"
#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

struct TopicGuess {
  TopicNumber topic = no_topic;
  double probability = 0;
};

struct SlotGuess {
  std::string slot;
  std::uint32_t begin = 0; // tokens
  std::uint32_t end = 0;
};

// The utterance's words; what stands for a value that is known is of its kind.
std::vector<LearningWord> learning_words(const Utterance& utterance,
                                         const Spans& spans);

// What learning may take.
struct LearningLimits {
  std::size_t features = 8 << 20; // of all examples; of eight bytes each
  std::size_t weights = 16 << 20; // of topics and of slots; of four bytes each
};

class Learned {
public:
  // Examples whose marks do not fit are left out. `threshold`: with many
  // examples, probabilities are made such that of 100 examples that were not
  // learnt 97 reach it. An error says what there is too much of.
  static Expected<Learned> train(const std::vector<TopicModel>& topics,
                                 const Schema& schema,
                                 const Automaton& automaton, double threshold,
                                 LearningLimits limits = {});

  // Best first, of topics with examples. What is left to 1 is the probability
  // that it is about none of them. None for words that no example has anything
  // of: all that is known then is which topic has the most examples.
  std::vector<TopicGuess> topics(const std::vector<LearningWord>& words) const;

  // Words that fill the topic's slots, in their order; `features` are
  // word_features.
  std::vector<SlotGuess>
  slots(TopicNumber topic,
        const std::vector<std::vector<Feature>>& features) const;

  bool empty() const {
    return topics_.empty();
  }

private:
  friend class Lesson;

  std::vector<TopicNumber> topics_; // of labels, from the second on
  std::vector<std::string> slots_;
  std::vector<std::vector<std::uint32_t>> slots_of_; // by topic
  Classifier classifier_;
  Tagger tagger_;
  float sharpness_ = 1; // what scores are multiplied with
};

} // namespace parlour::adapters::nlu
