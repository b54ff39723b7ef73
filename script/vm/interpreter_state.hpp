// The state of an interpreter and its activations as bytes
// (runtime/base/bytes.hpp, object_bytes.hpp). Another process that has compiled
// the same program continues from them as if nothing had happened. A state has
// exactly one form: reading and writing it again gives the same bytes.
//
//   version       a byte, state_version
//   program       fixed, identity_of(program)
//   objects       count, objects
//   fuel          two numbers: of one event, left; a byte: grace was given
//   variables     a box each, or 6: its initial value (initial_values.hpp)
//   messages      count; for each time (signed), number, source, command,
//                 count and values of its parameters, count and texts of its
//                 sinks, session, correlation, rounds
//   activations   count; for each:
//     context     message (0: none, else its position from 1), topic and slot
//                 (number plus one, 0: none), turn; a byte each: handles an
//                 error, writes, leaves a state
//     waiting     a byte
//     frames      count, outermost first: code, instruction, unused capacity
//                 of registers, registers
//     copy-outs   count; for each the positions of frame, parameter, variable
//
// A register is a box (object_bytes.hpp) or
//   6 a missing argument   7 bound to a variable: its number
//   8 bound to a register: position of its frame, register
//
// Reading checks everything that the machine relies on. Damaged and forged
// bytes give an error of kind File, never a crash.
#pragma once

#include "script/vm/machine.hpp"

namespace parlour::script {

// Raised with each change of the format.
inline constexpr std::uint8_t state_version = 5;

// These follow the tags of a box. Only parameters that are bound, and arguments
// that a call will take, have them (frame_check.hpp).
enum class RegisterTag : std::uint8_t {
  missing = 6,
  bound_variable = 7,
  bound_register = 8,
};

using Executions = std::vector<std::unique_ptr<Execution>>;

// No activation of the machine may be running.
std::string state_of(const Machine& machine,
                     const std::vector<const Execution*>& executions);

// The machine must be new. An error is of kind File.
Expected<Executions> restore_state(Machine& machine, std::string_view bytes);

} // namespace parlour::script
