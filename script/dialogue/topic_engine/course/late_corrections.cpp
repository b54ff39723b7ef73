#include "script/dialogue/topic_engine/course/late_corrections.hpp"

#include <algorithm>
#include <utility>

namespace parlour::dialogue {

// As long as nothing else is going on and it is fresh (`context-for`). A topic
// that is being completed is not done yet; its values can still be changed as
// usual.
std::optional<TopicId> LateCorrections::just_done() const {
  const auto latest = frames_.order().latest();
  const auto& sessions = context_.program->settings.sessions;
  if (frames_.order().current() || !latest ||
      frames_[*latest].status != TopicStatus::completed ||
      confirmations_.is_completing(*latest) ||
      context_.now - settling_.completed_at() >= sessions.context_for.count())
    return {};
  return latest;
}

// All slots must be that topic's: "no, the blue one" about another topic must
// not order the taxi again.
LateCorrections::Outcome LateCorrections::take(const steps::TopicAct& step) {
  const auto latest = just_done();
  if (!latest || step.act->slots.empty())
    return Outcome::no_concern;
  for (const auto& value : step.act->slots)
    if (context_.topic(*latest).slot(value.slot) == script::no_id)
      return Outcome::no_concern;
  const auto outcome = judge(*latest, *step.act);
  if (outcome != Outcome::taken)
    return outcome;
  auto act = *step.act;
  act.topic = context_.topic(*latest).name;
  act.kind = ActKind::correct;
  topic_changes_.keep_for(std::move(act));
  if (repairs_.repair({.act = "correct", .topic = *latest, .turn = step.turn}))
    return Outcome::taken;
  topic_changes_.forget();
  return Outcome::no_concern;
}

// "no, at four" is a correction. Where the application says how a change is
// mended, so is "I am with Comptec" if the topic had no company (or else it is
// the next visitor), and a part of a sentence: "half six is better". Elsewhere
// they begin the topic anew.
LateCorrections::Outcome LateCorrections::judge(TopicId topic,
                                                const Act& act) const {
  if (act.kind == ActKind::correct)
    return Outcome::taken;
  const auto& declared = context_.topic(topic);
  if (act.kind != ActKind::inform || frames_.resting() ||
      !has_own_repair(topic, "correct") ||
      (act.topic != declared.name && !act.topic.empty() && !act.elliptical))
    return Outcome::no_concern;
  bool says_again = true;
  for (const auto& said : act.slots) {
    const auto slot = declared.slot(said.slot);
    const auto& state = frames_[topic].slots[slot];
    const bool is_known = !state.value.is_unknown() && !state.by_default;
    if (declared.slots[slot].many)
      return Outcome::no_concern;
    if (is_known && state.value == said.value)
      continue;
    if (is_known && !act.elliptical)
      return Outcome::no_concern;
    says_again = false;
  }
  if (!says_again)
    return Outcome::taken;
  return act.elliptical ? Outcome::says_again : Outcome::no_concern;
}

bool LateCorrections::has_own_repair(TopicId topic,
                                     std::string_view act) const {
  return std::ranges::any_of(
      context_.program->repairs, [&](const auto& repair) {
        return repair.topic == topic && repair.act == act;
      });
}

TopicId LateCorrections::taken_back() const {
  const auto latest = just_done();
  return latest && has_own_repair(*latest, "cancel") ? *latest : script::no_id;
}

} // namespace parlour::dialogue
