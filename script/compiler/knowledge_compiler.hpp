// <query> and <facts>: how a topic is answered (engine rule 6).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// The program's facts are complete before queries are compiled.
void compile_query(const Element& element, Topic& topic,
                   Compilation& compilation);

// `topic`: the one that they stand in; no_id: none.
void compile_facts(const Element& element, TopicId topic,
                   Compilation& compilation);

} // namespace parlour::script
