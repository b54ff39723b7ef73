// Acts that are predicted by what was learnt from examples. They complete what
// grammars found: where these found nothing, only a value, or less than all
// that was said.
#pragma once

#include <vector>

#include "adapters/nlu/parse/built_act.hpp"
#include "adapters/nlu/understand/trained_model.hpp"

namespace parlour::adapters::nlu {

// The act of the most likely topic, then those of topics that are almost as
// likely. Acts below the threshold are left out.
std::vector<BuiltAct> hypothesised_acts(const TrainedModel& learned,
                                        const Utterance& utterance,
                                        Spans& spans, const Schema& schema,
                                        const Context& context,
                                        double threshold);

// What a task needs above the threshold to be begun by words alone: who asks
// "how old are you" wants no taxi.
inline constexpr double task_without_values = 0.1;

// Leaves the act with the best score, and those about other topics that are
// nearly as good behind it, in the order of their scores.
void keep_best(std::vector<BuiltAct>& acts);

// The values that clearly fill slots of the topic.
std::vector<Fill> certain_fills(const Utterance& utterance, Spans& spans,
                                const Schema& schema, TopicNumber topic);

// Whether there is room for one more: a slot is filled once, but for one with
// several values; a word fills one slot.
bool may_fill(const std::vector<Fill>& fills, const Fill& more, bool many);

} // namespace parlour::adapters::nlu
