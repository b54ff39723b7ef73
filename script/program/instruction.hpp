// The operations as an enumeration, from instructions.def.
#pragma once

#include <cstdint>

namespace parlour::script {

enum class Operation : std::uint8_t {
#define INSTRUCTION(name, sentence) name,
#include "script/program/instructions.def"
#undef INSTRUCTION
};

const char* name_of(Operation operation);

} // namespace parlour::script
