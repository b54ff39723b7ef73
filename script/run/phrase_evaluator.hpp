// What an NLG component says, from the program's <phrases> (runtime/base
// phrases.hpp). The composition root hands it to components.
#pragma once

#include <memory>

#include "runtime/base/phrases.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

// Of the phrases whose act, topic and slot match, the most specific ones whose
// condition holds (topic and slot, then topic, then act alone; at each, the
// application's before the platform's) take turns by `rotation`.
std::shared_ptr<const PhraseEvaluator>
make_phrase_evaluator(std::shared_ptr<const Program> program);

} // namespace parlour::script
