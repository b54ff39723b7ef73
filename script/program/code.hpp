// Code: one compiled body or expression: a function of its arguments, run by
// the interpreter. The instruction set is instructions.def.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "script/program/jump_table.hpp"
#include "script/source/source.hpp"
#include "script/values/box.hpp"

namespace parlour::script {

using CodeId = std::uint32_t;
inline constexpr CodeId no_code = 0xffffffff;

// One step of the register machine: 8 bytes. `b` and `c` together hold a wide
// operand, such as the distance of a jump.
struct Instruction {
  std::uint8_t operation = 0;
  std::uint8_t flag = 0;
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

// Errors of the instructions [from, to) go to `target`, their value to
// `error_register`. A limit is passed by unless `always` (clean-up code).
struct CatchRange {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t target = 0;
  std::uint16_t error_register = 0;
  bool always = false;
};

// What an `effect` instruction sends: operands and captured values stand in
// consecutive registers.
struct EffectShape {
  std::uint8_t kind = 0; // EffectKind
  CodeId body = no_code;
  std::uint16_t operands = 0;
  std::uint16_t captured = 0;
  // The state or topic that the first operand names, where the name stands in
  // the script; else 0xffffffff.
  std::uint32_t target = 0xffffffff;
};

struct Code {
  std::string name; // for the script stack: "function NameVariationMap"
  std::uint16_t parameter_count = 0;
  std::uint16_t required_count = 0;
  std::uint16_t register_count = 0;
  std::uint16_t cost = 1; // fuel of a call; its loops and calls cost their own
  std::vector<Instruction> instructions;
  std::vector<Position> positions; // one for each instruction
  std::vector<Box> constants;      // immortal, owned by the program's pool
  std::vector<std::string> parameter_names;
  // Where the body begins; before it, missing arguments get their defaults.
  std::uint32_t body = 0;
  std::vector<CatchRange> catches; // innermost first
  std::vector<EffectShape> effects;
  std::vector<JumpTable> tables;
};

} // namespace parlour::script
