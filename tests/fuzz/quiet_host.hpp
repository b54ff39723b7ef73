// A host without effects. Every second effect that may wait does wait; the
// others return their first operand.
#pragma once

#include "script/program/effect_names.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::fuzz {

class QuietHost : public script::Host {
public:
  script::Performed perform(script::Activation&,
                            const script::Effect& effect) override {
    if (++performed_ % 2 == 0 && script::waits(effect.kind))
      return script::Waits{};
    return effect.operand(0);
  }
  Value slot(script::TopicId, script::SlotId id) const override {
    return static_cast<std::int64_t>(id);
  }
  void set_slot(script::TopicId, script::SlotId, Value) override {}
  Value system(const script::Activation&,
               script::SystemVariable variable) const override {
    return static_cast<std::int64_t>(variable);
  }
  bool online(const std::string& agent) const override {
    return agent.empty();
  }
  Timestamp now() const override {
    return 1'795'251'600'000;
  }
  double random() override {
    return 0.5;
  }

  // Runs the activation until it ends, for 20 rounds at most.
  static void finish(script::Interpreter& interpreter,
                     script::Activation& activation, script::RunResult result,
                     script::Host& host) {
    for (int waits = 0; waits < 20; ++waits) {
      if (result.status == script::RunStatus::yielded)
        result = interpreter.run(activation, host);
      else if (result.status == script::RunStatus::waiting)
        result = interpreter.resume(activation, Value(waits), host);
      else
        return;
    }
  }

private:
  int performed_ = 0;
};

} // namespace parlour::fuzz
