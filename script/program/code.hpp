// Code: a compiled body or expression, which the interpreter runs as a function
// of its arguments. The instruction set is in instructions.def.
//
// The machine has registers rather than an operand stack: the compiler gives
// each parameter, local variable and intermediate result a register of the call
// frame, so `a = b + c` is a single instruction that moves no values.
//
// A frame for `function f(a, b)` with a local variable c, while `g(c, 1)` is
// being prepared:
//
//   r0  a            parameters
//   r1  b
//   r2  c            local variables, in the order of their declaration
//   r3  c            temporaries: here the arguments of the call, and later
//   r4  1            its result in r3
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "script/program/jump_table.hpp"
#include "script/source/source.hpp"
#include "script/values/box.hpp"

namespace parlour::script {

// An index into Program::code.
using CodeId = std::uint32_t;
inline constexpr CodeId no_code = 0xffffffff;

// One instruction: eight bytes. `b` and `c` together are a wide operand, such
// as the distance of a jump.
struct Instruction {
  std::uint8_t operation = 0;
  std::uint8_t flag = 0; // a further small operand: a truth, a count
  std::uint16_t a = 0;
  std::uint16_t b = 0;
  std::uint16_t c = 0;

  std::uint32_t wide() const {
    return b | static_cast<std::uint32_t>(c) << 16;
  }
  std::int32_t distance() const {
    return static_cast<std::int32_t>(wide());
  }
  void set_wide(std::uint32_t value) {
    b = static_cast<std::uint16_t>(value);
    c = static_cast<std::uint16_t>(value >> 16);
  }
};

// Errors of the instructions [from, to) continue at `target`, with the error in
// `error_register`. A range that is `always` also runs when a limit is reached,
// which no <catch> may take (language rule 9.6): it is used for the end of a
// transaction.
struct CatchRange {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t target = 0;
  std::uint16_t error_register = 0;
  bool always = false;
};

// What an `effect` instruction hands to the host. Its operands are consecutive
// registers, followed by the captured values.
struct EffectShape {
  std::uint8_t kind = 0; // an EffectKind
  CodeId body = no_code;
  std::uint16_t operands = 0;
  std::uint16_t captured = 0;
  // The state or topic that the first operand names if the name is a constant;
  // otherwise 0xffffffff.
  std::uint32_t target = 0xffffffff;
};

// Immutable once compiled; owned by the program and shared by all sessions.
struct Code {
  std::string name; // for listings: "function NameVariationMap"
  std::uint16_t parameter_count = 0;
  std::uint16_t required_count = 0;
  std::uint16_t register_count = 0;
  std::uint16_t cost = 1; // fuel of a call; loops and calls inside cost extra
  std::vector<Instruction> instructions;
  std::vector<Position> positions; // of each instruction
  std::vector<Box> constants;      // immortal, owned by the program's pool
  std::vector<std::string> parameter_names;
  // The first instruction of the body. The instructions before it compute the
  // defaults of missing arguments.
  std::uint32_t body = 0;
  std::vector<CatchRange> catches; // innermost first
  std::vector<EffectShape> effects;
  std::vector<JumpTable> tables;
};

} // namespace parlour::script
