// Handlers for instructions that compare and jump. Included by dispatch.cpp
// only, which inlines each handler at its label.
//
// The form of all handlers: the fast path handles small integers, doubles and
// other frequent cases inline and touches the cursor only. Everything else
// calls a function of Machine, out of line, after save() has stored the current
// instruction in the frame, where errors and suspended calls need it. A handler
// returns false if the loop must stop: for an error, a wait, or the end.
#pragma once

#include "script/vm/handlers_values.hpp"

namespace parlour::script::handlers {

// -- comparing ----------------------------------------------------------------

// A long text costs fuel by its size.
PARLOUR_INLINE void charge_text(Machine& m, const StringObject& text) {
  if (text.size >= WalkBudget::bytes_per_instruction) [[unlikely]]
    m.take(WalkBudget::price_of_bytes(text.size));
}

// Identical bits are equal values, except that no box holds a NaN (language
// rule 2.5). Small integers with different bits are unequal.
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

// A template parameter of the handlers, so each is compiled for its relation.
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

// Small integers compare by their bits (box.hpp).
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
  const bool ok = m.order(left, right, found);
  result = holds(relation, found);
  return ok;
}

// The flag makes it serve != as well.
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

// Searching takes as long as the container is large, so it has no fast path.
PARLOUR_INLINE bool contained(Machine& m, Cursor& c) {
  save(m, c);
  return m.contained(c.r[c.pc->b], c.r[c.pc->c], c.r[c.pc->a]) && next(c);
}

// -- jumping ------------------------------------------------------------------

PARLOUR_INLINE bool jump(Machine&, Cursor& c) {
  c.pc += c.pc->distance();
  return true;
}

// Jumps back and charges fuel for the loop's body. Fuel is checked here and at
// calls only: between them code runs forward and ends. The frame stores the
// instruction to go on at, as the slice may end here.
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

// `flag` is the truth for which the jump is taken.
PARLOUR_INLINE bool jump_if(Machine&, Cursor& c) {
  const auto& box = c.r[c.pc->a];
  const bool is_true = box.is_boolean() ? box.is_true()
                       : box.is_small() ? box.as_small() != 0
                                        : truth(box.resolved());
  c.pc += is_true == (c.pc->flag != 0) ? c.pc->distance() : 1;
  return true;
}

// Skips the code that computes a default (language rule 7.4).
PARLOUR_INLINE bool jump_if_given(Machine&, Cursor& c) {
  c.pc += c.r[c.pc->a].is_missing() ? 1 : c.pc->distance();
  return true;
}

// A compare-and-jump has its distance in `c` alone, as `a` and `b` are
// operands.
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

// A value without an arm goes to the default. A value of another type than the
// table's falls through to the tests that follow.
PARLOUR_INLINE bool jump_by_table(Machine&, Cursor& c) {
  const auto& code = *c.r.frame().code;
  const auto* target = code.tables[c.pc->b].find(c.r[c.pc->a].resolved());
  c.pc = target ? code.instructions.data() + *target : c.pc + 1;
  return true;
}

} // namespace parlour::script::handlers
