// EffectHandler: carries out what scripts want (script/program/effects.def) by
// handing it to the part of the conversation that knows how. The interpreter's
// Host.
#pragma once

#include <map>
#include <set>
#include <string>

#include "runtime/base/random.hpp"
#include "script/dialogue/agenda/port.hpp"
#include "script/dialogue/agenda/step.hpp"
#include "script/dialogue/context/activation_runner.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/reactions.hpp"
#include "script/dialogue/context/waits.hpp"
#include "script/dialogue/engine/pipeline.hpp"
#include "script/dialogue/engine/sockets.hpp"
#include "script/dialogue/engine/state_machine.hpp"
#include "script/dialogue/engine/subscriptions.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"
#include "script/program/host.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

class EffectHandler final : public script::Host {
public:
  EffectHandler(DialogueContext& context, ActivationRunner& runner,
                Waits& waits, Reactions& reactions, OutputManager& output,
                TopicEngine& topics, StateMachine& machine,
                ScriptSockets& sockets, Pipeline& pipeline);

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

  // A reply to a <request>; false where none waits for it.
  bool reply(const Message& message);
  // The outcome of a <querydb>, of a transaction's ends, a <readfile>, <load>
  // …; false where it is none of these.
  bool answered(QueryId id, Expected<Value> outcome);
  bool waits_for_answer() const {
    return !requests_.empty() || !queries_.empty() ||
           sockets_.waits_for_answer();
  }
  void forget(WaitId wait);

private:
  using Performed = script::Performed;
  using Call = const script::Effect&;
  using Context = const script::ActivationContext&;

  Performed post(Context context, Call effect);
  void post_for(Message message); // another session
  List params_of(Call effect) const;
  Performed request(Context context, Call effect);
  Performed fire_frames(Context context, Call effect);
  Performed consume(Context context);
  Performed perform_dialogue(script::Activation& activation, Call effect);
  Performed perform_repair(script::Activation& activation, Call effect);
  Performed speak(Context context, Call effect);
  Performed say(Context context, Call effect);
  Performed ask_again(Context context, Call effect);
  Performed timer(Context context, Call effect);
  VisitId ends_with(const Value& said) const;
  Performed connect_database(script::Activation& activation, Call effect);
  Performed query_database(Context context, Call effect);
  Performed transaction(Context context, Call effect, QueryRequest::Kind kind);
  Performed ask_database(Context context, QueryRequest request,
                         const Value& named);
  Performed perform_outside(script::Activation& activation, Call effect);
  Performed file(FileRequest request);
  Performed open_socket(Call effect);
  Performed change_component(Call effect);
  Performed confirm(Context context, Call effect);
  Performed transit(Context context, Call effect);
  Performed later(StepKind kind, Context context, Call effect);
  Performed push(Context context, Call effect);
  Performed clear(Context context, Call effect);
  StateId state_of(Call effect) const;
  TopicId topic_of(Call effect) const;
  Performed register_topic(Call effect);
  Performed wait_for(Milliseconds time);

  // The running activation waits.
  WaitId begin_wait(ActivationRunner::WaitFor what);

  struct Connection {
    std::string component;
    bool write = false;
  };

  struct Query {
    WaitId wait = 0;
    bool rollback = false; // never fails: the error that led to it counts
  };

  DialogueContext& context_;
  ActivationRunner& runner_;
  Waits& waits_;
  Reactions& reactions_;
  OutputManager& output_;
  TopicEngine& topics_;
  StateMachine& machine_;
  ScriptSockets& sockets_;
  Pipeline& pipeline_;
  Subscriptions subscriptions_;
  std::map<Correlation, WaitId> requests_;
  std::map<QueryId, Query> queries_;
  std::map<std::string, Connection, std::less<>> connections_; // with a name
  std::string current_; // the component of those without; empty: the first
  Random random_;
};

} // namespace parlour::dialogue
