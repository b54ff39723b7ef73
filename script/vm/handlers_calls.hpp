// Handlers for containers, loops, calls and effects. Included by dispatch.cpp
// only; handlers_flow.hpp explains their form.
#pragma once

#include "script/vm/handlers_flow.hpp"

namespace parlour::script::handlers {

// -- containers ---------------------------------------------------------------

PARLOUR_INLINE bool get_entry(Machine& m, Cursor& c, MapObject& map,
                              const Box& key) {
  charge_text(m, *key.string());
  const auto* value = map.find(*key.string());
  c.r[c.pc->a] = value ? *value : Box();
  return next(c);
}

// The common cases are an existing element of a list and a string key of a map;
// everything else, and every error, is Machine's.
PARLOUR_INLINE bool get_index(Machine& m, Cursor& c) {
  const auto& container = c.r[c.pc->b];
  const auto& key = c.r[c.pc->c];
  if (container.is_list() && key.is_small()) {
    const auto& elements = container.list()->elements;
    const auto at = static_cast<std::uint64_t>(key.as_small());
    if (at < elements.size()) [[likely]] {
      c.r[c.pc->a] = elements[at];
      return next(c);
    }
  } else if (container.is_map() && key.is_string()) {
    return get_entry(m, c, *container.map(), key);
  }
  save(m, c);
  return m.get_index(container, key, c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool get_field(Machine& m, Cursor& c) {
  const auto& container = c.r[c.pc->b];
  if (container.is_map())
    return get_entry(m, c, *container.map(), c.k[c.pc->c]);
  save(m, c);
  return m.get_field(container, c.k[c.pc->c], c.r[c.pc->a]) && next(c);
}

// Sets an element that exists already, if the value is simple (so no ring can
// arise) and no memory is needed; otherwise Machine does it.
PARLOUR_INLINE bool set(Machine& m, Cursor& c, const Box& key) {
  const auto& container = c.r[c.pc->a];
  const auto& value = c.r[c.pc->c];
  ++m.writes;
  if (container.is_map() && key.is_string() && value.is_simple()) {
    charge_text(m, *key.string());
    if (auto* there = container.map()->find(*key.string())) [[likely]] {
      *there = value;
      return next(c);
    }
  } else if (container.is_list() && key.is_small() && value.is_simple()) {
    auto& elements = container.list()->elements;
    const auto at = static_cast<std::uint64_t>(key.as_small());
    if (at < elements.size()) [[likely]] {
      elements[at] = value;
      return next(c);
    }
  }
  save(m, c);
  return m.set_index(container, key, value) && next(c);
}

PARLOUR_INLINE bool set_index(Machine& m, Cursor& c) {
  return set(m, c, c.r[c.pc->b]);
}

PARLOUR_INLINE bool set_field(Machine& m, Cursor& c) {
  return set(m, c, c.k[c.pc->b]);
}

// These allocate, so they go to the machine at once.
PARLOUR_INLINE bool new_list(Machine& m, Cursor& c) {
  save(m, c);
  return m.new_list(c.r.range(c.pc->b, c.pc->c), c.pc->c, c.r[c.pc->a]) &&
         next(c);
}

PARLOUR_INLINE bool new_map(Machine& m, Cursor& c) {
  save(m, c);
  return m.new_map(c.r.range(c.pc->b, 2 * c.pc->c), c.pc->c, c.r[c.pc->a]) &&
         next(c);
}

PARLOUR_INLINE bool new_array(Machine& m, Cursor& c) {
  save(m, c);
  return m.new_array(c.r[c.pc->b], c.r[c.pc->a]) && next(c);
}

// The fast path needs spare capacity, so the heap's limit is not affected.
PARLOUR_INLINE bool append(Machine& m, Cursor& c) {
  const auto& list = c.r[c.pc->a];
  const auto& value = c.r[c.pc->b];
  ++m.writes;
  if (list.is_list() && value.is_simple()) {
    auto& elements = list.list()->elements;
    if (elements.size() < elements.capacity()) [[likely]] {
      elements.push_back(value);
      return next(c);
    }
  }
  save(m, c);
  return m.append(list, value) && next(c);
}

PARLOUR_INLINE bool concatenate(Machine& m, Cursor& c) {
  save(m, c);
  return m.concatenate(c.r.range(c.pc->b, c.pc->c), c.pc->c, c.r[c.pc->a]) &&
         next(c);
}

PARLOUR_INLINE bool milliseconds(Machine& m, Cursor& c) {
  save(m, c);
  return m.milliseconds(c.r[c.pc->b], c.r[c.pc->a]) && next(c);
}

// The registers of a <for> loop are described at Machine::for_prepare.
// -- loops --------------------------------------------------------------------

PARLOUR_INLINE bool for_prepare(Machine& m, Cursor& c) {
  save(m, c);
  bool enters = false;
  if (!m.for_prepare(&c.r[c.pc->a], enters))
    return false;
  c.pc += enters ? 1 : c.pc->distance();
  return true;
}

// The fast path counts in small integers. The variable gets a copy of the
// current value: what the body assigns to it changes no round (language rule
// 6.4).
PARLOUR_INLINE bool for_next(Machine& m, Cursor& c) {
  auto* loop = &c.r[c.pc->a];
  const auto left = loop[0].as_small();
  if (left == 0) [[unlikely]]
    return next(c);
  if (Box::both_small(loop[1], loop[2]) && loop[4].take_sum(loop[1], loop[2]))
      [[likely]] {
    loop[0].set_uncounted(Box::small(left - 1));
    loop[1].set_uncounted(loop[4]);
    return back(m, c);
  }
  save(m, c);
  return m.for_next(loop) && back(m, c);
}

// Preparing copies the list, so it is not worth a fast path.
PARLOUR_INLINE bool each_prepare(Machine& m, Cursor& c) {
  save(m, c);
  return m.each_prepare(c.r[c.pc->b], &c.r[c.pc->a]) && next(c);
}

// loop: the list, the position of the next element, the element and its index.
PARLOUR_INLINE bool each_next(Machine&, Cursor& c) {
  auto* loop = &c.r[c.pc->a];
  const auto position = loop[1].as_small();
  const auto& elements = loop[0].list()->elements;
  if (position >= static_cast<std::int64_t>(elements.size())) {
    c.pc += c.pc->distance();
    return true;
  }
  loop[2] = elements[static_cast<std::size_t>(position)];
  loop[3] = loop[1];
  loop[1] = Box::small(position + 1);
  return next(c);
}

// -- calls --------------------------------------------------------------------

// Moves the arguments to the callee's frame and continues there. The frame is
// usually the one that the previous call at this depth has left.
PARLOUR_INLINE bool call(Machine& m, Cursor& c) {
  save(m, c);
  const auto& callee = m.code[c.pc->wide()];
  auto* frame =
      m.enter(&c.r.frame(), callee, c.r.range(c.pc->a, c.pc->flag), c.pc->flag);
  if (!frame) [[unlikely]]
    return false;
  c = {frame->pc, Registers(*frame), callee.constants.data()};
  m.fuel -= callee.cost;
  if (m.fuel > 0) [[likely]]
    return true;
  return m.within_limits() && m.refuel();
}

// The current instruction is saved, because a built-in may raise an error.
PARLOUR_INLINE bool call_builtin(Machine& m, Cursor& c) {
  save(m, c);
  return m.call_builtin(c.pc->b, c.r.range(c.pc->a, c.pc->flag), c.pc->flag,
                        c.r[c.pc->c]) &&
         next(c);
}

// The function is looked up at run time; the frame may have changed afterwards.
PARLOUR_INLINE bool call_named(Machine& m, Cursor& c) {
  save(m, c);
  const auto ok = m.call_named(c.r.range(c.pc->a, c.pc->c), c.pc->c);
  c = at_top(*m.execution);
  return ok;
}

// Ends the top frame. The fast path returns to a caller: the value goes to
// register `a` of its call instruction, where it stopped. The slow path ends
// the activation, or copies parameters back to variables first.
PARLOUR_INLINE bool leave(Machine& m, Cursor& c, Box& value) {
  auto* frame = &c.r.frame();
  auto* caller = frame->caller;
  if (!caller || m.execution->copy_outs) [[unlikely]] {
    if (!m.give_back(value.resolved()))
      return false;
    c = at_top(*m.execution);
    return true;
  }
  const auto* pc = caller->pc;
  auto& result = caller->registers()[pc->a];
  if (value.is_reference()) [[unlikely]]
    result = *value.target();
  else
    result = std::move(value);
  frame->clear();
  m.execution->top = caller;
  c = {pc + 1, Registers(*caller), caller->code->constants.data()};
  return true;
}

PARLOUR_INLINE bool give_back(Machine& m, Cursor& c) {
  return leave(m, c, c.r[c.pc->a]);
}

PARLOUR_INLINE bool give_unknown(Machine& m, Cursor& c) {
  Box unknown;
  return leave(m, c, unknown);
}

// Returning false sends the dispatch loop to recover(), which finds the
// <catch>.
PARLOUR_INLINE bool raise(Machine& m, Cursor& c) {
  save(m, c);
  return m.raise_box(c.r[c.pc->a]);
}

// The result arrives in register `a`, now or when the activation is resumed.
PARLOUR_INLINE bool effect(Machine& m, Cursor& c) {
  save(m, c);
  const auto& shape = m.execution->top->code->effects[c.pc->c];
  return m.perform(shape, c.r.range(c.pc->b, 0), c.r[c.pc->a]) && next(c);
}

// Coverage is decided once for each run, so unwatched runs only test a flag.
PARLOUR_INLINE bool reached(Machine& m, Cursor& c) {
  if (m.watched) {
    const auto* code = m.execution->top->code;
    m.host->reached(code->positions[static_cast<std::size_t>(
        c.pc - code->instructions.data())]);
  }
  return next(c);
}

} // namespace parlour::script::handlers
