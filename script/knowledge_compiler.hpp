// <query> and <facts>: how a topic is answered (engine rule 6).
#pragma once

#include "script/compilation.hpp"

namespace parlour::script {

// `fact_tables` of the program are complete before queries are compiled.
void compile_query(const Element& element, Topic& topic,
                   Compilation& compilation);

void compile_facts(const Element& element, Compilation& compilation);

} // namespace parlour::script
