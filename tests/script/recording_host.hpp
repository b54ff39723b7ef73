// A host that records effects and returns the answers that a test has set.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "script/vm/interpreter.hpp"

namespace parlour::test {

// An effect with its operands copied out.
struct RecordedEffect {
  explicit RecordedEffect(const script::Effect& effect)
      : kind(effect.kind), body(effect.body), captured(effect.captured()) {
    for (std::size_t i = 0; i < effect.operand_count(); ++i)
      operands.push_back(effect.operand(i));
  }
  Value operand(std::size_t index) const {
    return index < operands.size() ? operands[index] : Value();
  }

  script::EffectKind kind;
  script::CodeId body;
  std::vector<Value> operands;
  std::vector<Value> captured;
};

class RecordingHost : public script::Host {
public:
  script::Performed perform(script::Activation&,
                            const script::Effect& effect) override {
    effects.emplace_back(effect);
    if (answers.empty())
      return Value();
    auto answer = std::move(answers.front());
    answers.pop_front();
    return answer;
  }
  Value slot(script::TopicId, script::SlotId id) const override {
    const auto there = slots.find(id);
    return there == slots.end() ? Value() : there->second;
  }
  void set_slot(script::TopicId, script::SlotId id, Value value) override {
    slots[id] = std::move(value);
  }
  Value system(const script::Activation&,
               script::SystemVariable variable) const override {
    return variable == script::SystemVariable::state ? Value("Welcome")
                                                     : Value();
  }
  bool online(const std::string& agent) const override {
    return agent == "Robot";
  }
  Timestamp now() const override {
    return 1'000;
  }
  double random() override {
    return 0.5;
  }
  bool watches_branches() const override {
    return true;
  }
  void reached(script::Position position) override {
    branches.push_back(position.line);
  }

  std::vector<RecordedEffect> effects;
  std::deque<script::Performed> answers; // then unknown
  std::map<script::SlotId, Value> slots;
  std::vector<std::uint32_t> branches;
};

} // namespace parlour::test
