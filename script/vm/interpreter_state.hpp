// The state of an interpreter and its activations as bytes
// (runtime/base/bytes.hpp, object_bytes.hpp), from which another process that
// has compiled the same program goes on as if nothing had happened. One state
// has one form: what is read and written again gives the same bytes.
//
//   version       a byte, state_version
//   program       fixed, identity_of(program)
//   objects       count, objects
//   fuel          number each: of one event, left; a byte: grace given
//   variables     a box each
//   messages      count; for each time (signed), number, source, command,
//                 count and values of its parameters, count and texts of its
//                 sinks, session, correlation
//   activations   count, each
//     context     message (0: none, else its place from 1), topic and slot
//                 (number plus one, 0: none), turn; a byte each: handles an
//                 error, writes, leaves a state
//     waiting     a byte
//     frames      count, outermost first: code, instruction, room for so many
//                 more registers, registers
//     copy-outs   count, each the place of a frame, parameter, variable
//
// A register is a box or
//   6 a missing argument   7 bound to a variable: number
//   8 bound to a register: place of its frame, register
//
// Reading checks everything that the machine takes for granted: bytes that
// were damaged or made up give an error of kind File, never a crash.
#pragma once

#include "script/vm/machine.hpp"

namespace parlour::script {

inline constexpr std::uint8_t state_version = 3;

// Beside the tags of a box (object_bytes.hpp).
enum class RegisterTag : std::uint8_t {
  missing = 6,
  bound_variable = 7,
  bound_register = 8,
};

using Executions = std::vector<std::unique_ptr<Execution>>;

// No activation of the machine may be running.
std::string state_of(const Machine& machine,
                     const std::vector<const Execution*>& executions);

// Into a machine that is new.
Expected<Executions> restore_state(Machine& machine, std::string_view bytes);

} // namespace parlour::script
