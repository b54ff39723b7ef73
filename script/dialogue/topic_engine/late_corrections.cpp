#include "script/dialogue/topic_engine/late_corrections.hpp"

#include <utility>

namespace parlour::dialogue {

// A correction while nothing is going on is about what was completed last, as
// long as that is fresh.
bool LateCorrections::take(const steps::TopicAct& step) {
  const auto latest = frames_.order().latest();
  const auto& sessions = context_.program->settings.sessions;
  if (step.act->kind != ActKind::correct || step.act->slots.empty() ||
      frames_.order().current() || !latest ||
      frames_[*latest].status != TopicStatus::completed ||
      confirmations_.is_completing(*latest) ||
      context_.now - settling_.completed_at() >= sessions.context_for.count())
    return false;
  for (const auto& value : step.act->slots)
    if (context_.topic(*latest).slot(value.slot) == script::no_id)
      return false;
  auto act = *step.act;
  act.topic = context_.topic(*latest).name;
  topic_changes_.keep_for(std::move(act));
  return repairs_.repair(
      {.act = "correct", .topic = *latest, .turn = step.turn});
}

} // namespace parlour::dialogue
