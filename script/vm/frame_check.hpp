// FrameCheck: what the machine relies on about the registers of a frame at a
// given instruction. For running code the compiler guarantees it. A stored
// state is checked against it when it is read, so that no sequence of bytes can
// make the machine treat a number as a list, count beyond 64 bits, or keep a
// binding to a frame that has ended.
//
// It is computed by one pass over the instructions, without following jumps:
// the compiler lays out calls, defaults and loops so that their extent in the
// code is enough.
#pragma once

#include <cstdint>
#include <vector>

#include "script/program/code.hpp"

namespace parlour::script {

class FrameCheck {
public:
  // `at` must be the index of an instruction.
  FrameCheck(const Code& code, std::uint32_t at);

  // Whether the register may hold a bound parameter, or a missing argument. In
  // other places such a value is left over from before and is never read.
  bool may_be_bound(std::uint16_t reg) const;
  bool may_be_missing(std::uint16_t reg) const;
  // Whether a loop around the instruction is controlled by this register. No
  // parameter may be bound to it, as setting it would break the loop.
  bool steers_a_loop(std::uint16_t reg) const;
  // What is wrong with the registers that control the loops around the
  // instruction; null if nothing is.
  const char* find_broken_loop(const Box* registers) const;

private:
  // An argument in a register from which a call will take it.
  struct Argument {
    std::uint16_t reg;
    bool bound; // else missing
  };
  void prepare(const Instruction& instruction, std::uint32_t index);
  void pass(std::size_t first, std::size_t count, std::uint32_t index);

  const Code& code_;
  std::uint32_t at_;
  std::vector<Argument> prepared_; // for a later call
  std::vector<Argument> waiting_;  // for a call behind at_
  std::vector<std::uint16_t> defaults_;
  std::vector<std::uint16_t> counting_; // first registers of loops
  std::vector<std::uint16_t> walking_;
};

} // namespace parlour::script
