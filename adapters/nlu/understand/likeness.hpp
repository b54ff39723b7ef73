// What an utterance is like, of all that the application's rules say. Where
// neither rules nor examples understand anything, an utterance that is much
// like what a rule says is taken for it (docs/understanding.md, "Much like a
// rule"). What is more like talk about anything else is about nothing of the
// application ("Other talk").
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/grammar/sampled_sentences.hpp"
#include "adapters/nlu/learning/nearest_texts.hpp"
#include "adapters/nlu/parse/built_act.hpp"
#include "adapters/nlu/understand/trained_model.hpp"

namespace parlour::adapters::nlu {

// Immutable; any number of threads may use it.
class Likeness {
public:
  struct Like {
    SentenceMeaning meaning;
    std::string sentence; // that a rule says
    double similarity = 0;
    // Its slots, and the kinds of their values.
    std::vector<std::pair<std::string, EntityId>> values;
  };

  // Of what rules say. `other_talk` are sentences that are about nothing of any
  // application.
  Likeness(const Automaton& automaton,
           const std::vector<SampledSentence>& sentences,
           const std::vector<std::string>& other_talk);

  // The meanings that it is most like, the most similar first.
  std::vector<Like> likes(const Utterance& utterance,
                          const std::vector<LearningWord>& words) const;

  // The act that the utterance is most like, and others that are nearly as
  // similar. Empty if none reaches the threshold by its similarity and the
  // bonus for being expected.
  std::vector<BuiltAct> acts(const Utterance& utterance, Spans& spans,
                             const std::vector<LearningWord>& words,
                             const Schema& schema, const Context& context,
                             double threshold) const;

  // Leaves acts out that say only a part of an utterance which is more like
  // other talk than like what rules say; whether there were any. What the
  // conversation expects stays.
  bool leave_out_other_talk(std::vector<BuiltAct>& acts,
                            const Utterance& utterance, const Spans& spans,
                            const TrainedModel& learned,
                            const Context& context) const;

private:
  struct Said;

  Said said(const Utterance& utterance,
            const std::vector<LearningWord>& words) const;

  std::vector<SentenceMeaning> meanings_;
  std::vector<std::string> sentences_; // by text
  std::vector<std::vector<std::pair<std::string, EntityId>>> values_;
  std::vector<std::string> words_; // by number of the automaton
  bool knows_other_talk_ = false;
  NearestTexts texts_;
};

} // namespace parlour::adapters::nlu
