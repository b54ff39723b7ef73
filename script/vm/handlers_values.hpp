// Handlers of the instructions that move and compute.
// Included by dispatch.cpp only: each is inlined at its label there. What is
// not quick goes to Machine's slow ways, out of line. A handler gives false
// when the loop must look around: an error, a wait, the end.
#pragma once

#include "script/vm/machine.hpp"

namespace parlour::script::handlers {

struct Cursor {
  const Instruction* pc;
  Box* r;       // registers
  const Box* k; // constants
};

PARLOUR_INLINE Cursor at_top(const Execution& execution) {
  auto* frame = execution.top;
  return {frame->pc, frame->registers(), frame->code->constants.data()};
}

PARLOUR_INLINE void save(Machine&, Cursor& c) {
  Frame::of(c.r)->pc = c.pc;
}

PARLOUR_INLINE bool next(Cursor& c, bool well = true) {
  ++c.pc;
  return well;
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

PARLOUR_INLINE bool load_parameter(Machine&, Cursor& c) {
  c.r[c.pc->a] = c.r[c.pc->b].resolved();
  return next(c);
}

PARLOUR_INLINE bool store_parameter(Machine&, Cursor& c) {
  c.r[c.pc->a].resolved() = c.r[c.pc->b];
  return next(c);
}

PARLOUR_INLINE bool bind_register(Machine&, Cursor& c) {
  c.r[c.pc->a] = Box::reference(&c.r[c.pc->b].resolved());
  return next(c);
}

PARLOUR_INLINE bool bind_variable(Machine& m, Cursor& c) {
  c.r[c.pc->a] = Box::reference(&m.variables[c.pc->b]);
  return next(c);
}

PARLOUR_INLINE bool load_variable(Machine& m, Cursor& c) {
  c.r[c.pc->a] = m.variables[c.pc->b];
  return next(c);
}

PARLOUR_INLINE bool store_variable(Machine& m, Cursor& c) {
  m.variables[c.pc->b] = c.r[c.pc->a];
  return next(c);
}

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

PARLOUR_INLINE bool finite(double value) {
  return value - value == 0;
}

PARLOUR_INLINE bool put_number(Cursor& c, double value) {
  if (!finite(value)) [[unlikely]]
    return false;
  c.r[c.pc->a] = Box::number(value);
  return true;
}

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
  const auto& right = c.k[c.pc->c]; // small, as in all that take a constant
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

// Of what is not negative; the short division takes half as long.
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

PARLOUR_INLINE bool negate(Machine& m, Cursor& c) {
  save(m, c);
  return m.negate(c.r[c.pc->b], c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool invert(Machine&, Cursor& c) {
  c.r[c.pc->a] = Box::boolean(!truth(c.r[c.pc->b].resolved()));
  return next(c);
}

} // namespace parlour::script::handlers
