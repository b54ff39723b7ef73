// Handlers for instructions that move values and compute. Included by
// dispatch.cpp only; handlers_flow.hpp explains their form.
#pragma once

#include <cassert>

#include "script/vm/machine.hpp"

namespace parlour::script::handlers {

// The registers of the running frame. A debug build asserts that each index is
// one of its code.
class Registers {
public:
  explicit Registers(CallFrame& frame) : boxes_(frame.registers()) {}

  PARLOUR_INLINE Box& operator[](std::size_t index) const {
    assert(index < frame().code->register_count);
    return boxes_[index];
  }
  // `count` of them, which may be none.
  PARLOUR_INLINE Box* range(std::size_t first, std::size_t count) const {
    assert(first + count <= frame().code->register_count);
    (void)count;
    return boxes_ + first;
  }
  PARLOUR_INLINE CallFrame& frame() const {
    return *CallFrame::of(boxes_);
  }

private:
  Box* boxes_;
};

// The state of the running frame, which the compiler keeps in registers of the
// processor between instructions.
struct Cursor {
  const Instruction* pc;
  Registers r;
  const Box* k; // constants
};

PARLOUR_INLINE Cursor at_top(const Execution& execution) {
  auto* frame = execution.top;
  return {frame->pc, Registers(*frame), frame->code->constants.data()};
}

// Stores the current instruction in the frame.
PARLOUR_INLINE void save(Machine&, Cursor& c) {
  c.r.frame().pc = c.pc;
}

// Whether the cursor is at an instruction of its code.
inline bool is_inside(const Cursor& c) {
  const auto& all = c.r.frame().code->instructions;
  return c.pc >= all.data() && c.pc < all.data() + all.size();
}

// Moves to the next instruction; passes on whether all went well.
PARLOUR_INLINE bool next(Cursor& c, bool ok = true) {
  ++c.pc;
  assert(is_inside(c));
  return ok;
}

// -- moving -------------------------------------------------------------------

PARLOUR_INLINE bool load_constant(Machine&, Cursor& c) {
  c.r[c.pc->a] = c.k[c.pc->b];
  return next(c);
}

PARLOUR_INLINE bool move(Machine&, Cursor& c) {
  c.r[c.pc->a] = c.r[c.pc->b];
  return next(c);
}

// Parameters may be bound to a variable of the caller (language rule 7.3), so
// they have instructions of their own, and other locals need no test.
PARLOUR_INLINE bool load_parameter(Machine&, Cursor& c) {
  c.r[c.pc->a] = c.r[c.pc->b].resolved();
  return next(c);
}

// Into the bound variable, if there is one.
PARLOUR_INLINE bool store_parameter(Machine& m, Cursor& c) {
  auto& parameter = c.r[c.pc->a];
  m.writes += parameter.is_reference();
  parameter.resolved() = c.r[c.pc->b];
  return next(c);
}

// A parameter can be bound to a parameter that is bound itself; resolving here
// keeps the chain at one link.
PARLOUR_INLINE bool bind_register(Machine&, Cursor& c) {
  c.r[c.pc->a] = Box::reference(&c.r[c.pc->b].resolved());
  return next(c);
}

PARLOUR_INLINE bool bind_variable(Machine& m, Cursor& c) {
  c.r[c.pc->a] = Box::reference(&m.variable(c.pc->b));
  return next(c);
}

PARLOUR_INLINE bool load_variable(Machine& m, Cursor& c) {
  c.r[c.pc->a] = m.variable(c.pc->b);
  return next(c);
}

PARLOUR_INLINE bool store_variable(Machine& m, Cursor& c) {
  ++m.writes;
  m.variables[c.pc->b] = c.r[c.pc->a];
  return next(c);
}

// Slots, system variables and parameters of the message come from outside and
// cost fuel by their size.
PARLOUR_INLINE bool load_slot(Machine& m, Cursor& c) {
  m.load_slot(c.pc->wide(), c.r[c.pc->a]);
  return next(c);
}

PARLOUR_INLINE bool store_slot(Machine& m, Cursor& c) {
  m.store_slot(c.pc->wide(), c.r[c.pc->a]);
  return next(c);
}

PARLOUR_INLINE bool load_system(Machine& m, Cursor& c) {
  m.load_system(static_cast<SystemVariable>(c.pc->b), c.r[c.pc->a]);
  return next(c);
}

PARLOUR_INLINE bool load_message_parameter(Machine& m, Cursor& c) {
  m.load_message_parameter(c.pc->b, c.r[c.pc->a]);
  return next(c);
}

PARLOUR_INLINE bool load_message_parameters(Machine& m, Cursor& c) {
  m.load_message_parameters(c.r[c.pc->a]);
  return next(c);
}

// -- arithmetic ---------------------------------------------------------------

// False for infinities and NaN, whose difference with themselves is NaN.
PARLOUR_INLINE bool finite(double value) {
  return value - value == 0;
}

PARLOUR_INLINE bool put_number(Cursor& c, double value) {
  if (!finite(value)) [[unlikely]]
    return false;
  c.r[c.pc->a] = Box::number(value);
  return true;
}

// If a fast path finds that the result does not fit, nothing has been changed
// and the slow path computes it again.
PARLOUR_INLINE bool add(Machine& m, Cursor& c) {
  const auto& left = c.r[c.pc->b];
  const auto& right = c.r[c.pc->c];
  if (Box::both_small(left, right)) [[likely]] {
    if (c.r[c.pc->a].take_sum(left, right)) [[likely]]
      return next(c);
  } else if (left.is_number() && right.is_number()) {
    if (put_number(c, left.as_number() + right.as_number())) [[likely]]
      return next(c);
  }
  save(m, c);
  return m.add(left, right, c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool slow_arithmetic(Machine& m, Cursor& c, Arithmetic operation,
                                    const Box& right) {
  save(m, c);
  return m.arithmetic(operation, c.r[c.pc->b], right, c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool subtract(Machine& m, Cursor& c) {
  const auto& left = c.r[c.pc->b];
  const auto& right = c.r[c.pc->c];
  if (Box::both_small(left, right)) [[likely]] {
    if (c.r[c.pc->a].take_difference(left, right)) [[likely]]
      return next(c);
  } else if (left.is_number() && right.is_number()) {
    if (put_number(c, left.as_number() - right.as_number())) [[likely]]
      return next(c);
  }
  return slow_arithmetic(m, c, Arithmetic::subtract, right);
}

PARLOUR_INLINE bool add_constant(Machine& m, Cursor& c) {
  const auto& left = c.r[c.pc->b];
  const auto& right = c.k[c.pc->c]; // always a small integer
  if (left.is_small() && c.r[c.pc->a].take_sum(left, right)) [[likely]]
    return next(c);
  save(m, c);
  return m.add(left, right, c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool subtract_constant(Machine& m, Cursor& c) {
  const auto& left = c.r[c.pc->b];
  const auto& right = c.k[c.pc->c];
  if (left.is_small() && c.r[c.pc->a].take_difference(left, right)) [[likely]]
    return next(c);
  return slow_arithmetic(m, c, Arithmetic::subtract, right);
}

// Products of small integers may need more than 48 bits; then the slow path
// makes an object or a number.
PARLOUR_INLINE bool multiply(Machine& m, Cursor& c) {
  const auto& left = c.r[c.pc->b];
  const auto& right = c.r[c.pc->c];
  if (Box::both_small(left, right)) [[likely]] {
    if (c.r[c.pc->a].take_product(left, right)) [[likely]]
      return next(c);
  } else if (left.is_number() && right.is_number()) {
    if (put_number(c, left.as_number() * right.as_number())) [[likely]]
      return next(c);
  }
  return slow_arithmetic(m, c, Arithmetic::multiply, right);
}

// The remainder of two numbers that are not negative. A division of 32 bits
// takes about half as long as one of 64 bits.
PARLOUR_INLINE std::int64_t rest_of(std::int64_t left, std::int64_t right) {
  if (((left | right) >> 32) == 0) [[likely]]
    return static_cast<std::uint32_t>(left) % static_cast<std::uint32_t>(right);
  return left % right;
}

PARLOUR_INLINE bool modulo(Machine& m, Cursor& c) {
  const auto& left = c.r[c.pc->b];
  const auto& right = c.r[c.pc->c];
  if (Box::both_small(left, right) && left.as_small() >= 0 &&
      right.as_small() > 0) [[likely]] {
    c.r[c.pc->a] = Box::small(rest_of(left.as_small(), right.as_small()));
    return next(c);
  }
  return slow_arithmetic(m, c, Arithmetic::modulo, right);
}

PARLOUR_INLINE bool multiply_constant(Machine& m, Cursor& c) {
  const auto& left = c.r[c.pc->b];
  const auto& right = c.k[c.pc->c];
  if (left.is_small() && c.r[c.pc->a].take_product(left, right)) [[likely]]
    return next(c);
  return slow_arithmetic(m, c, Arithmetic::multiply, right);
}

// Division has no fast path: even integers may give a number.
PARLOUR_INLINE bool divide(Machine& m, Cursor& c) {
  return slow_arithmetic(m, c, Arithmetic::divide, c.r[c.pc->c]);
}

PARLOUR_INLINE bool modulo_constant(Machine& m, Cursor& c) {
  const auto& left = c.r[c.pc->b];
  const auto& right = c.k[c.pc->c];
  if (left.is_small() && left.as_small() >= 0 && right.as_small() > 0)
      [[likely]] {
    c.r[c.pc->a] = Box::small(rest_of(left.as_small(), right.as_small()));
    return next(c);
  }
  return slow_arithmetic(m, c, Arithmetic::modulo, right);
}

// Rare, as the sign of a literal is part of the literal.
PARLOUR_INLINE bool negate(Machine& m, Cursor& c) {
  save(m, c);
  return m.negate(c.r[c.pc->b], c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool invert(Machine&, Cursor& c) {
  c.r[c.pc->a] = Box::boolean(!truth(c.r[c.pc->b].resolved()));
  return next(c);
}

} // namespace parlour::script::handlers
