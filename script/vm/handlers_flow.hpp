// Handlers of the instructions that compare and jump.
// Included by dispatch.cpp only: each is inlined at its label there. What is
// not quick goes to Machine's slow ways, out of line. A handler gives false
// when the loop must look around: an error, a wait, the end.
#pragma once

#include "script/vm/handlers_values.hpp"

namespace parlour::script::handlers {

// -- comparing ----------------------------------------------------------------

// Long texts cost by their size.
PARLOUR_INLINE void charge_text(Machine& m, const StringObject& text) {
  constexpr std::uint32_t bytes_per_unit = 128; // of a plain comparison
  if (text.size > bytes_per_unit) [[unlikely]]
    m.fuel -= text.size / bytes_per_unit;
}

PARLOUR_INLINE bool are_equal(Machine& m, Cursor& c, const Box& left,
                              const Box& right, bool& result) {
  if (left.same_bits(right)) {
    result = true;
    return true;
  }
  if (Box::both_small(left, right)) {
    result = false;
    return true;
  }
  if (left.is_string() && right.is_string()) {
    charge_text(m, *left.string());
    result = equal_strings(*left.string(), *right.string());
    return true;
  }
  save(m, c);
  return m.equal(left, right, result);
}

enum class Relation { less, less_equal, greater, greater_equal };

template <class T>
PARLOUR_INLINE bool holds(Relation relation, T left, T right) {
  switch (relation) {
  case Relation::less:
    return left < right;
  case Relation::less_equal:
    return left <= right;
  case Relation::greater:
    return left > right;
  default:
    return left >= right;
  }
}

inline bool holds(Relation relation, Order order) {
  switch (relation) {
  case Relation::less:
    return order == Order::less;
  case Relation::less_equal:
    return order == Order::less || order == Order::equal;
  case Relation::greater:
    return order == Order::greater;
  default:
    return order == Order::greater || order == Order::equal;
  }
}

template <Relation relation>
PARLOUR_INLINE bool compared(Machine& m, Cursor& c, const Box& left,
                             const Box& right, bool& result) {
  if (Box::both_small(left, right)) [[likely]] {
    result = holds(relation, left.ordered_bits(), right.ordered_bits());
    return true;
  }
  if (left.is_number() && right.is_number()) {
    result = holds(relation, left.as_number(), right.as_number());
    return true;
  }
  save(m, c);
  Order found = Order::none;
  const bool well = m.order(left, right, found);
  result = holds(relation, found);
  return well;
}

PARLOUR_INLINE bool equal(Machine& m, Cursor& c) {
  bool result = false;
  if (!are_equal(m, c, c.r[c.pc->b], c.r[c.pc->c], result))
    return false;
  c.r[c.pc->a] = Box::boolean(result == (c.pc->flag != 0));
  return next(c);
}

template <Relation relation>
PARLOUR_INLINE bool put_compared(Machine& m, Cursor& c) {
  bool result = false;
  if (!compared<relation>(m, c, c.r[c.pc->b], c.r[c.pc->c], result))
    return false;
  c.r[c.pc->a] = Box::boolean(result);
  return next(c);
}

PARLOUR_INLINE bool less(Machine& m, Cursor& c) {
  return put_compared<Relation::less>(m, c);
}

PARLOUR_INLINE bool less_equal(Machine& m, Cursor& c) {
  return put_compared<Relation::less_equal>(m, c);
}

PARLOUR_INLINE bool contained(Machine& m, Cursor& c) {
  save(m, c);
  return m.contained(c.r[c.pc->b], c.r[c.pc->c], c.r[c.pc->a]) && next(c);
}

// -- jumping ------------------------------------------------------------------

PARLOUR_INLINE bool jump(Machine&, Cursor& c) {
  c.pc += c.pc->distance();
  return true;
}

// Saves the place to go on at: a slice may end here.
PARLOUR_INLINE bool back(Machine& m, Cursor& c) {
  const auto distance = c.pc->distance();
  c.pc -= distance;
  m.fuel -= distance + 1;
  if (m.fuel > 0) [[likely]]
    return true;
  save(m, c);
  return m.refuel();
}

PARLOUR_INLINE bool loop(Machine& m, Cursor& c) {
  return back(m, c);
}

PARLOUR_INLINE bool jump_if(Machine&, Cursor& c) {
  const auto& box = c.r[c.pc->a];
  const bool is_true = box.is_boolean() ? box.is_true()
                       : box.is_small() ? box.as_small() != 0
                                        : truth(box.resolved());
  c.pc += is_true == (c.pc->flag != 0) ? c.pc->distance() : 1;
  return true;
}

PARLOUR_INLINE bool jump_if_given(Machine&, Cursor& c) {
  c.pc += c.r[c.pc->a].is_missing() ? 1 : c.pc->distance();
  return true;
}

PARLOUR_INLINE void branch(Cursor& c, bool result) {
  c.pc += result == (c.pc->flag != 0) ? static_cast<std::int16_t>(c.pc->c) : 1;
}

PARLOUR_INLINE bool branch_equal(Machine& m, Cursor& c, const Box& right) {
  bool result = false;
  if (!are_equal(m, c, c.r[c.pc->a], right, result))
    return false;
  branch(c, result);
  return true;
}

template <Relation relation>
PARLOUR_INLINE bool branch_order(Machine& m, Cursor& c, const Box& right) {
  bool result = false;
  if (!compared<relation>(m, c, c.r[c.pc->a], right, result))
    return false;
  branch(c, result);
  return true;
}

PARLOUR_INLINE bool jump_if_equal(Machine& m, Cursor& c) {
  return branch_equal(m, c, c.r[c.pc->b]);
}

PARLOUR_INLINE bool jump_if_equal_constant(Machine& m, Cursor& c) {
  return branch_equal(m, c, c.k[c.pc->b]);
}

PARLOUR_INLINE bool jump_if_less(Machine& m, Cursor& c) {
  return branch_order<Relation::less>(m, c, c.r[c.pc->b]);
}

PARLOUR_INLINE bool jump_if_less_constant(Machine& m, Cursor& c) {
  return branch_order<Relation::less>(m, c, c.k[c.pc->b]);
}

PARLOUR_INLINE bool jump_if_less_equal(Machine& m, Cursor& c) {
  return branch_order<Relation::less_equal>(m, c, c.r[c.pc->b]);
}

PARLOUR_INLINE bool jump_if_less_equal_constant(Machine& m, Cursor& c) {
  return branch_order<Relation::less_equal>(m, c, c.k[c.pc->b]);
}

PARLOUR_INLINE bool jump_if_greater_constant(Machine& m, Cursor& c) {
  return branch_order<Relation::greater>(m, c, c.k[c.pc->b]);
}

PARLOUR_INLINE bool jump_if_greater_equal_constant(Machine& m, Cursor& c) {
  return branch_order<Relation::greater_equal>(m, c, c.k[c.pc->b]);
}

PARLOUR_INLINE bool jump_by_table(Machine&, Cursor& c) {
  const auto& code = *Frame::of(c.r)->code;
  const auto* target = code.tables[c.pc->b].find(c.r[c.pc->a].resolved());
  c.pc = target ? code.instructions.data() + *target : c.pc + 1;
  return true;
}

} // namespace parlour::script::handlers
