#include "script/vm/frame_check.hpp"

#include <algorithm>
#include <limits>

#include "script/program/instruction.hpp"
#include "script/values/operations.hpp"

namespace parlour::script {

// One pass over all instructions. For each kind it relies on how the compiler
// lays out code:
//
//   a default    jump_if_given over the instructions that compute it
//   a <for>      for_next jumps back to the first instruction of the body
//   <for each>   each_next jumps over the body
//   a call       its arguments are prepared before it, in registers that
//                the call names
FrameCheck::FrameCheck(const Code& code, std::uint32_t at)
    : code_(code), at_(at) {
  for (std::uint32_t i = 0; i < code.instructions.size(); ++i) {
    const auto& instruction = code.instructions[i];
    switch (static_cast<Operation>(instruction.operation)) {
    case Operation::bind_register:
    case Operation::bind_variable:
    case Operation::load_constant:
      prepare(instruction, i);
      break;
    case Operation::call:
    case Operation::call_builtin:
      pass(instruction.a, instruction.flag, i);
      break;
    case Operation::call_named:
      pass(instruction.a + std::size_t{1}, instruction.c, i);
      break;
    case Operation::jump_if_given: // skips what computes the default
      if (at < i + instruction.wide())
        defaults_.push_back(instruction.a);
      break;
    case Operation::for_next: // jumps back to the body
      if (at + instruction.wide() >= i && at <= i)
        counting_.push_back(instruction.a);
      break;
    case Operation::each_next: // skips the body
      if (at >= i && at < i + instruction.wide())
        walking_.push_back(instruction.a);
      break;
    default:
      break;
    }
  }
}

// Notes an argument that is put in place before the instruction at_.
void FrameCheck::prepare(const Instruction& instruction, std::uint32_t index) {
  if (index >= at_)
    return;
  const bool bound =
      static_cast<Operation>(instruction.operation) != Operation::load_constant;
  if (bound || code_.constants[instruction.b].is_missing())
    prepared_.push_back({instruction.a, bound});
}

// The call takes its arguments. If the call is at or behind at_, they are
// waiting in their registers at that moment.
void FrameCheck::pass(std::size_t first, std::size_t count,
                      std::uint32_t index) {
  std::erase_if(prepared_, [&](const Argument& argument) {
    if (argument.reg < first || argument.reg >= first + count)
      return false;
    if (index >= at_)
      waiting_.push_back(argument);
    return true;
  });
}

bool FrameCheck::may_be_bound(std::uint16_t reg) const {
  return reg < code_.parameter_count ||
         std::any_of(waiting_.begin(), waiting_.end(),
                     [&](const Argument& argument) {
                       return argument.reg == reg && argument.bound;
                     });
}

bool FrameCheck::may_be_missing(std::uint16_t reg) const {
  return std::count(defaults_.begin(), defaults_.end(), reg) > 0 ||
         std::any_of(waiting_.begin(), waiting_.end(),
                     [&](const Argument& argument) {
                       return argument.reg == reg && !argument.bound;
                     });
}

namespace {

// Whether a count of `times` steps stays within 64 bits. The distances are
// computed unsigned, as from the smallest to the largest integer they do not
// fit otherwise.
bool can_step(std::int64_t from, std::int64_t step, std::int64_t times) {
  using Limits = std::numeric_limits<std::int64_t>;
  const auto apart = [](std::int64_t high, std::int64_t low) {
    return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
  };
  if (step == 0)
    return true;
  // How many steps fit between `from` and the end of the range of integers.
  const auto max_times = step > 0 ? apart(Limits::max(), from) / apart(step, 0)
                                  : apart(from, Limits::min()) / apart(0, step);
  return static_cast<std::uint64_t>(times) <= max_times;
}

// The registers are those of Machine::for_prepare: left, current, step, from,
// variable.
bool can_count(const Box* loop) {
  if (!loop[0].is_small() || loop[0].as_small() < 0)
    return false;
  if (loop[1].is_number())
    return numeric(loop[2]) && numeric(loop[3]);
  return loop[1].is_integer() && loop[2].is_integer() &&
         can_step(loop[1].as_integer(), loop[2].as_integer(),
                  loop[0].as_small());
}

// Those of Machine::each_prepare: the list and the position.
bool can_walk(const Box* loop) {
  return loop[0].is_list() && loop[1].is_small() && loop[1].as_small() >= 0;
}

} // namespace

bool FrameCheck::steers_a_loop(std::uint16_t reg) const {
  const auto within = [reg](const auto& loops, int size) {
    return std::any_of(loops.begin(), loops.end(), [&](std::uint16_t first) {
      return reg >= first && reg < first + size;
    });
  };
  return within(counting_, 4) || within(walking_, 2); // not its variable
}

const char* FrameCheck::find_broken_loop(const Box* registers) const {
  for (const auto reg : counting_)
    if (!can_count(registers + reg))
      return "a <for> has not what it counts with";
  for (const auto reg : walking_)
    if (!can_walk(registers + reg))
      return "a <for each> has not what it walks over";
  return nullptr;
}

} // namespace parlour::script
