// Compiles <query> and <facts>: how a topic is answered (engine rule 6).
//
// The statement itself is made when the query runs (engine rule 6.2); here its
// parts are checked and resolved.
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// All facts of the program must have been compiled before.
void compile_query(const Element& element, Topic& topic,
                   Compilation& compilation);

// `topic`: the topic in which the facts stand; no_id if they belong to all.
void compile_facts(const Element& element, TopicId topic,
                   Compilation& compilation);

} // namespace parlour::script
