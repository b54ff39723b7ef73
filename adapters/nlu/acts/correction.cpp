#include "adapters/nlu/acts/correction.hpp"

#include <algorithm>
#include <optional>

namespace parlour::adapters::nlu {

namespace {

// Whether the act is a correction that only fills the slot which is being asked
// for.
bool only_answers(const BuiltAct& act, const Context& context) {
  return act.act == "correct" && act.topic != no_topic &&
         act.topic == context.asked_topic && act.fills.size() == 1 &&
         act.fills[0].slot == context.asked_slot && !act.fills[0].literal;
}

bool is_value(const Fill& fill, const Spans& spans) {
  return fill.span && !spans[*fill.span].unmatched &&
         spans[*fill.span].entity != words_entity;
}

// The same words as a value of another entity; nothing if they
// cannot be one.
std::optional<Fill> as_value(const Fill& fill, EntityId entity,
                             const Spans& spans) {
  auto made = fill;
  made.span.reset();
  if (entity == words_entity)
    return is_value(fill, spans) ? std::nullopt : std::optional(made);
  for (const auto index : spans.at(entity, fill.begin))
    if (spans[index].end == fill.end) {
      made.span = index;
      return made;
    }
  return {};
}

bool has_list(const BuiltAct& act, const Schema& schema) {
  return std::ranges::any_of(act.fills, [&](const Fill& fill) {
    return schema.at(act.topic).takes_many(fill.slot);
  });
}

bool is_corrected_by(const BuiltAct& said, const BuiltAct& act,
                     const Schema& schema) {
  return said.act == "inform" && act.act == "correct" &&
         said.topic != no_topic && said.topic == act.topic && !said.negated &&
         !said.fills.empty() && !act.fills.empty() && !has_list(said, schema) &&
         !has_list(act, schema);
}

// A later value of a slot replaces an earlier one.
void join(BuiltAct& said, const BuiltAct& correction) {
  for (const auto& fill : correction.fills) {
    std::erase_if(said.fills, [&](const Fill& earlier) {
      return earlier.slot == fill.slot;
    });
    said.fills.push_back(fill);
  }
  said.end = correction.end;
  said.score = std::min(said.score, correction.score);
  said.understood = std::min(said.understood, correction.understood);
}

} // namespace

void correct_what_was_said(BuiltAct& act, const Spans& spans,
                           const Context& context) {
  if (!only_answers(act, context))
    return;
  for (auto slot = context.said.rbegin(); slot != context.said.rend(); ++slot)
    if (auto made = as_value(act.fills[0], slot->entity, spans)) {
      made->slot = slot->name;
      act.fills = {std::move(*made)};
      return;
    }
}

void join_corrections(std::vector<BuiltAct>& acts, const Schema& schema) {
  for (auto act = acts.begin(); act != acts.end();) {
    const auto said = std::find_if(acts.begin(), act, [&](const BuiltAct& one) {
      return is_corrected_by(one, *act, schema);
    });
    if (said == act) {
      ++act;
      continue;
    }
    join(*said, *act);
    act = acts.erase(act);
  }
}

} // namespace parlour::adapters::nlu
