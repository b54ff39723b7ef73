// Chooses between what grammars found and what was learnt of examples and
// wordings (docs/understanding.md). Pure.
#pragma once

#include <optional>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"
#include "adapters/nlu/parse/context.hpp"
#include "adapters/nlu/parse/spans.hpp"

namespace parlour::adapters::nlu {

// Made for one utterance, without its courtesies; all must outlive it.
class BetterReading {
public:
  // A hypothesis that is `well_taught` is also better than a whole sentence
  // that was understood in part, about what nobody expects.
  BetterReading(const Schema& schema, const Context& context,
                const Utterance& utterance, const Spans& spans,
                bool well_taught)
      : schema_(schema), context_(context), utterance_(utterance),
        spans_(spans), well_taught_(well_taught) {}

  // Whether the acts that grammars found only open or close what is said. True
  // for none.
  bool are_openings(const std::vector<BuiltAct>& acts) const;

  // Whether they are so few or so weak that the examples may know more.
  bool leaves_open(const std::vector<BuiltAct>& acts) const;

  // Puts the hypothesis in the place of the acts if it is better; otherwise
  // adds the slots that it found beside them. True if it took their place. A
  // bare value about the topic that the context expects is kept, whatever the
  // examples say.
  bool choose(std::vector<BuiltAct>& acts, const BuiltAct& hypothesis) const;

private:
  bool name_what_ends(const std::vector<BuiltAct>& acts) const;
  bool are_weak_courtesies(const std::vector<BuiltAct>& acts) const;
  bool is_better(const BuiltAct& act, const BuiltAct& hypothesis) const;
  bool is_better_sentence(const BuiltAct& act,
                          const BuiltAct& hypothesis) const;
  std::optional<double> needed_instead_of(const BuiltAct& act,
                                          const BuiltAct& hypothesis) const;
  bool keeps(const BuiltAct& hypothesis, const Fill& fill) const;
  bool is_same_value(const Fill& one, const Fill& other) const;
  bool is_meant_by(const Fill& literal, const Fill& said) const;
  bool is_doubtful(const Fill& fill) const;
  bool leaves_words(const BuiltAct& act) const;
  bool leaves_content(const BuiltAct& act) const;
  bool knows_no_value(const BuiltAct& act) const;
  bool leaves_question(const BuiltAct& act) const;
  bool is_clear(const Fill& fill) const;

  const Schema& schema_;
  const Context& context_;
  const Utterance& utterance_;
  const Spans& spans_;
  bool well_taught_;
};

} // namespace parlour::adapters::nlu
