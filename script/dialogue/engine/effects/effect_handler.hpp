// EffectHandler: carries out what scripts want (script/program/effects.def) by
// handing it to the part of the conversation that knows how. The interpreter's
// Host.
#pragma once

#include <string>

#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/context/script_view.hpp"
#include "script/dialogue/engine/effects/outside_effects.hpp"
#include "script/dialogue/engine/effects/reaction_effects.hpp"
#include "script/dialogue/engine/effects/request_effects.hpp"
#include "script/dialogue/engine/effects/time_effects.hpp"
#include "script/dialogue/engine/effects/topic_effects.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

// Called by the interpreter while a script runs. Most effects only note
// something (a step in the RunningScript, a message in the inbox) and return at
// once; those that wait return Waits, and the activation is suspended.
class EffectHandler final : public script::Host {
public:
  EffectHandler(ScriptView& view, RunningScript& running, TopicEffects& topics,
                ReactionEffects& reactions, RequestEffects& requests,
                TimeEffects& time, OutsideEffects& outside)
      : view_(view), running_(running), topics_(topics), reactions_(reactions),
        requests_(requests), time_(time), outside_(outside) {}

  // An error that it returns is thrown in the script, at the statement.
  script::Performed perform(script::Activation& activation,
                            const script::Effect& effect) override;
  Value slot(TopicId topic, SlotId slot) const override;
  void set_slot(TopicId topic, SlotId slot, Value value) override;
  Value system(const script::Activation& activation,
               script::SystemVariable variable) const override;
  bool online(const std::string& agent) const override;
  Timestamp now() const override;
  double random() override;
  bool watches_branches() const override;
  void reached(script::Position position) override;

private:
  using Call = const script::Effect&;

  // The parts that effects.def names.
  script::Performed requests(script::Activation& activation, Call effect);
  script::Performed reactions(script::Activation& activation, Call effect);
  script::Performed time(script::Activation& activation, Call effect);
  script::Performed topics(script::Activation& activation, Call effect);
  script::Performed outside(script::Activation& activation, Call effect);
  script::Performed conversation(script::Activation& activation, Call effect);
  script::Performed about_topic(const script::ActivationContext& context,
                                Call effect);

  ScriptView& view_;
  RunningScript& running_;
  TopicEffects& topics_;
  ReactionEffects& reactions_;
  RequestEffects& requests_;
  TimeEffects& time_;
  OutsideEffects& outside_;
};

} // namespace parlour::dialogue
