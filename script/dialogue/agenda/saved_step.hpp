// How a step is saved (saved/archive.hpp): the place of its kind in steps.def,
// then its fields in the table's order. What the step's taker relies on is
// checked when it is read. Bytes may be made up by anybody: a step that names a
// rule of a topic that has none must fail here and not when the step is taken.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

#include "script/dialogue/agenda/step.hpp"

namespace parlour::dialogue {

// Whether Kind is one of Kinds.
template <class Kind, class... Kinds>
inline constexpr bool is_one_of = (std::same_as<Kind, Kinds> || ...);

// Those whose topic may be none: all topics, or a script of none.
template <class Kind>
inline constexpr bool may_lack_topic =
    is_one_of<Kind, steps::Cancel, steps::Push>;
template <class Kind>
inline constexpr bool may_lack_state = is_one_of<Kind, steps::Leave>;
template <class Kind>
inline constexpr bool may_lack_code = is_one_of<Kind, steps::Transit>;

template <class Archive>
void check_lookup(Archive& archive, TopicId topic, const Lookup& lookup) {
  const auto& queries = archive.program().topics[topic].queries;
  const auto& statement = lookup.statement;
  archive.check(lookup.query.is_of(archive.program().topics[topic]) &&
                    statement.source < queries.size() &&
                    statement.kind == queries[statement.source].kind,
                "a query is another topic's");
}

// A topic is there, and so are those of its slots that are spoken of.
template <class Archive, class Kind>
void check_topic(Archive& archive, const Kind& step) {
  const auto& topics = archive.program().topics;
  archive.is_below(step.topic, topics.size(), "there is no such topic");
  if constexpr (requires { step.slot; })
    archive.is_there(step.topic, step.slot);
  if constexpr (!may_lack_topic<Kind>)
    archive.needs(step.topic);
  if (step.topic >= topics.size())
    return;
  if constexpr (requires { step.result; })
    for (std::size_t i = 0; step.result && i < step.result->reports.size(); ++i)
      archive.is_there(step.topic, step.result->reports[i].slot);
  if constexpr (requires { step.lookup; })
    if (step.lookup)
      check_lookup(archive, step.topic, *step.lookup);
}

// What steps of several kinds have in common, by the names of their fields.
template <class Archive, class Kind>
void check_step(Archive& archive, const Kind& step) {
  const auto& program = archive.program();
  if constexpr (requires { step.act; })
    archive.needs(step.act);
  if constexpr (requires { step.outcome; })
    archive.needs(step.outcome);
  if constexpr (requires { step.rung; })
    archive.is_below(step.rung, program.code.size(), "there is no such code");
  if constexpr (requires { step.body; } && !may_lack_code<Kind>)
    archive.needs(step.body.code);
  if constexpr (requires { step.state; }) {
    archive.is_below(step.state, program.states.size(),
                     "there is no such state");
    if constexpr (!may_lack_state<Kind>)
      archive.needs(step.state);
  }
}

// What only one kind relies on.
template <class Archive>
void check_kind(Archive& archive, const steps::Rule& step) {
  const auto& topics = archive.program().topics;
  archive.check(step.topic < topics.size() &&
                    step.index < topics[step.topic].rules.size(),
                "there is no such rule");
}
template <class Archive>
void check_kind(Archive& archive, const steps::Part& step) {
  const auto& topics = archive.program().topics;
  archive.check(step.topic < topics.size() &&
                    step.slot < topics[step.topic].slots.size() &&
                    topics[step.topic].slots[step.slot].part != script::no_id,
                "no topic fills that slot");
}
template <class Archive>
void check_kind(Archive& archive, const steps::Report& step) {
  archive.check(step.result && step.index < step.result->reports.size(),
                "there is no such report");
}
template <class Archive>
void check_kind(Archive& archive, const steps::LookedUp& step) {
  archive.needs(step.lookup);
}
template <class Archive>
void check_kind(Archive& archive, const steps::RunTimer& step) {
  archive.needs(step.ring);
}
template <class Archive, class Kind>
void check_kind(Archive&, const Kind&) {}

// One that stands outside of a list; its owner knows what else it needs.
template <class Archive, class Kind>
requires requires(Kind& step) {
  visit_fields(step, [](auto&) {});
}
void serialize_step(Archive& archive, Kind& step) {
  visit_fields(step, [&](auto& field) {
    if constexpr (std::same_as<decltype(field), OutputAct&>)
      archive.up_to(field, OutputAct::chat);
    else
      archive(field);
  });
  if constexpr (requires { step.topic; })
    check_topic(archive, step);
}

// Makes it the step of that place in the table.
template <std::size_t... Places>
void become(Step& step, std::size_t place, std::index_sequence<Places...>) {
  ((place == Places ? static_cast<void>(step.template emplace<Places>())
                    : void()),
   ...);
}

template <class Archive>
void serialize_step(Archive& archive, Step& step) {
  constexpr auto kinds = std::variant_size_v<Step>;
  auto place = step.index();
  archive.place(place, kinds);
  if constexpr (Archive::reads)
    become(step, place, std::make_index_sequence<kinds>());
  std::visit(
      [&](auto& kind) {
        serialize_step(archive, kind);
        check_step(archive, kind);
        check_kind(archive, kind);
      },
      step);
}

} // namespace parlour::dialogue
