// What the machine takes for granted about a frame's registers at an
// instruction, because the compiler sees to it. A state that is read back is
// held to it, so that no bytes can make the machine follow what is no list,
// count beyond 64 bits or keep a binding to a frame that has ended.
#pragma once

#include <cstdint>
#include <vector>

#include "script/program/code.hpp"

namespace parlour::script {

class FrameCheck {
public:
  // `at` is an instruction of the code.
  FrameCheck(const Code& code, std::uint32_t at);

  // Whether the register may hold a bound parameter, or a missing argument.
  // Elsewhere one is left over and never read again.
  bool may_be_bound(std::uint16_t reg) const;
  bool may_be_missing(std::uint16_t reg) const;
  // Whether a loop that the place is inside of goes by it, so that no parameter
  // may be bound to it.
  bool steers_a_loop(std::uint16_t reg) const;
  // Null where the loops that the place is inside of have what they need.
  const char* find_broken_loop(const Box* registers) const;

private:
  struct Argument {
    std::uint16_t reg;
    bool bound; // else missing
  };
  void prepare(const Instruction& instruction, std::uint32_t index);
  void pass(std::size_t first, std::size_t count, std::uint32_t index);

  const Code& code_;
  std::uint32_t at_;
  std::vector<Argument> prepared_; // for a call that comes
  std::vector<Argument> waiting_;  // those that it has not taken yet
  std::vector<std::uint16_t> defaults_;
  std::vector<std::uint16_t> counting_; // loops, by their first register
  std::vector<std::uint16_t> walking_;
};

} // namespace parlour::script
