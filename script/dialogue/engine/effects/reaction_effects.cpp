#include "script/dialogue/engine/effects/reaction_effects.hpp"

#include <memory>
#include <utility>

#include "script/dialogue/engine/effects/effect_operands.hpp"
#include "script/dialogue/topics/misnamed.hpp"

namespace parlour::dialogue {

script::Performed ReactionEffects::fire_event(TurnId turn,
                                              const script::Effect& effect) {
  messenger_.raise("Script", effect.text(0), list_of(effect.operand(1)), turn);
  return Value();
}

// What is wrong with the form of a frame is shown, and the rest counts. A wrong
// name is an error of the script: the act would go to another topic.
script::Performed ReactionEffects::fire_frames(TurnId turn,
                                               const script::Effect& effect) {
  auto parsed = parse_acts(effect.operand(0));
  const auto place = context_.program->place(effect.position);
  for (const auto& problem : parsed.problems)
    context_.inspect(InspectionKind::error, "fire",
                     to_string(Error{ErrorKind::range, problem, place}));
  // Who listens to Dialogue may know names that no topic has.
  for (const auto& act : parsed.acts)
    if (!reactions_.listens("Dialogue", std::string(name_of(act.kind))))
      if (auto error = misnamed(*context_.program, act))
        return std::move(*error);
  if (parsed.acts.empty())
    running_.later(steps::NoMatch{turn});
  for (auto& act : parsed.acts)
    running_.later(
        steps::TakeAct{std::make_shared<const Act>(std::move(act)), turn});
  return Value();
}

// What is offered to the reactions to Dialogue is a message, too, whose number
// is the offer's. Such a reaction may say <consume/> after a wait, when others
// are being handled.
script::Performed ReactionEffects::consume(const Message* message) {
  if (message && message->source == "Dialogue")
    offers_.consume(message->number);
  else if (!handled_.consume())
    return Error{
        ErrorKind::refused, "<consume>: no message is being handled here", {}};
  return Value();
}

script::Performed
ReactionEffects::register_handler(const script::Effect& effect) {
  reactions_.register_handler(
      effect.text(0), effect.kind == script::EffectKind::register_handler);
  return Value();
}

} // namespace parlour::dialogue
