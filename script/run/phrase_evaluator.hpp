// The words of an NLG component, from the program's <phrases>
// (runtime/message/phrases.hpp). The composition root hands it to components.
//
// An example: the engine asks for words by {act: "confirm", topic: "Taxi",
// slot: "Time", data: {value: "3pm"}}, and the phrase `A taxi at {data.value}?`
// gives "A taxi at 3pm?".
#pragma once

#include <memory>

#include "runtime/message/phrases.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

// Selects among the phrases whose act, topic and slot match. The most specific
// ones whose condition holds take turns by `rotation`: phrases with topic and
// slot come first, then with a topic, then with a slot, then with the act
// alone; at each of these levels the application's come before the platform's.
std::shared_ptr<const PhraseEvaluator>
make_phrase_evaluator(std::shared_ptr<const Program> program);

} // namespace parlour::script
