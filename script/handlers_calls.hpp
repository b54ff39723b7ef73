// Handlers of containers, loops, calls and effects.
// Included by dispatch.cpp only, see handlers_values.hpp.
#pragma once

#include "script/handlers_flow.hpp"

namespace parlour::script::handlers {

// -- containers ---------------------------------------------------------------

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
  }
  save(m, c);
  return m.get_index(container, key, c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool get_field(Machine& m, Cursor& c) {
  save(m, c);
  return m.get_field(c.r[c.pc->b], c.k[c.pc->c], c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool set_index(Machine& m, Cursor& c) {
  save(m, c);
  return m.set_index(c.r[c.pc->a], c.r[c.pc->b], c.r[c.pc->c]) && next(c);
}

PARLOUR_INLINE bool set_field(Machine& m, Cursor& c) {
  save(m, c);
  return m.set_index(c.r[c.pc->a], c.k[c.pc->b], c.r[c.pc->c]) && next(c);
}

PARLOUR_INLINE bool new_list(Machine& m, Cursor& c) {
  save(m, c);
  return m.new_list(&c.r[c.pc->b], c.pc->c, c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool new_map(Machine& m, Cursor& c) {
  save(m, c);
  return m.new_map(&c.r[c.pc->b], c.pc->c, c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool new_array(Machine& m, Cursor& c) {
  save(m, c);
  return m.new_array(c.r[c.pc->b], c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool append(Machine& m, Cursor& c) {
  save(m, c);
  return m.append(c.r[c.pc->a], c.r[c.pc->b]) && next(c);
}

PARLOUR_INLINE bool concatenate(Machine& m, Cursor& c) {
  save(m, c);
  return m.concatenate(&c.r[c.pc->b], c.pc->c, c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool milliseconds(Machine& m, Cursor& c) {
  save(m, c);
  return m.milliseconds(c.r[c.pc->b], c.r[c.pc->a]) && next(c);
}

// -- loops --------------------------------------------------------------------

PARLOUR_INLINE bool for_prepare(Machine& m, Cursor& c) {
  save(m, c);
  bool enters = false;
  if (!m.for_prepare(&c.r[c.pc->a], enters))
    return false;
  c.pc += enters ? 1 : c.pc->distance();
  return true;
}

PARLOUR_INLINE bool for_next(Machine& m, Cursor& c) {
  auto* loop = &c.r[c.pc->a];
  const auto left = loop[0].as_small();
  if (left == 0)
    return next(c);
  const auto following = loop[1].is_small() && loop[2].is_small()
                             ? loop[1].as_small() + loop[2].as_small()
                             : std::int64_t{1} << 60;
  if (Box::fits(following)) [[likely]] {
    loop[0] = Box::small(left - 1);
    loop[1] = Box::small(following);
    loop[4] = Box::small(following);
    return back(m, c);
  }
  save(m, c);
  return m.for_next(loop) && back(m, c);
}

PARLOUR_INLINE bool each_prepare(Machine& m, Cursor& c) {
  save(m, c);
  return m.each_prepare(c.r[c.pc->b], &c.r[c.pc->a]) && next(c);
}

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

PARLOUR_INLINE bool call(Machine& m, Cursor& c) {
  save(m, c);
  const auto well =
      m.call(m.program->code[c.pc->wide()], &c.r[c.pc->a], c.pc->flag);
  c = at_top(*m.execution);
  return well;
}

PARLOUR_INLINE bool call_builtin(Machine& m, Cursor& c) {
  save(m, c);
  auto* arguments = &c.r[c.pc->a];
  return m.call_builtin(c.pc->b, arguments, c.pc->c, *arguments) && next(c);
}

PARLOUR_INLINE bool call_named(Machine& m, Cursor& c) {
  save(m, c);
  const auto well = m.call_named(&c.r[c.pc->a], c.pc->c);
  c = at_top(*m.execution);
  return well;
}

PARLOUR_INLINE bool give_back(Machine& m, Cursor& c) {
  if (!m.give_back(std::move(c.r[c.pc->a])))
    return false;
  c = at_top(*m.execution);
  return true;
}

PARLOUR_INLINE bool give_unknown(Machine& m, Cursor& c) {
  if (!m.give_back(Box()))
    return false;
  c = at_top(*m.execution);
  return true;
}

PARLOUR_INLINE bool raise(Machine& m, Cursor& c) {
  save(m, c);
  return m.raise_box(c.r[c.pc->a]);
}

PARLOUR_INLINE bool effect(Machine& m, Cursor& c) {
  save(m, c);
  const auto& shape = m.execution->top->code->effects[c.pc->c];
  return m.perform(shape, &c.r[c.pc->b], c.r[c.pc->a]) && next(c);
}

PARLOUR_INLINE bool reached(Machine& m, Cursor& c) {
  if (m.watched) {
    const auto* code = m.execution->top->code;
    m.host->reached(code->positions[static_cast<std::size_t>(
        c.pc - code->instructions.data())]);
  }
  return next(c);
}

} // namespace parlour::script::handlers
