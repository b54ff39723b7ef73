// The answer to "Is that right?" or "What should I change?" that names what is
// to be another and says no value: "the day", "no, change the time". Pure.
#pragma once

#include <optional>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// The act that corrects a slot of the context's changes, to a value that is not
// said yet. Nothing if the utterance says anything else, or names several.
std::optional<BuiltAct> named_slot_of(const Utterance& utterance,
                                      const Context& context);

// The answer in words that name no value: choice_of(), else named_slot_of().
std::optional<BuiltAct> choice_or_named_slot(const Utterance& utterance,
                                             const Context& context);

} // namespace parlour::adapters::nlu
