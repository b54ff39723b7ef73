#include "script/dialogue/context/text_evaluator.hpp"

#include <utility>

#include "script/program/computing_host.hpp"
#include "script/program/constant_text.hpp"

namespace parlour::dialogue {

namespace {

// What a script reads, without what it can do; its lines for developers hurt
// nobody.
class ViewHost final : public script::ComputingHost {
public:
  explicit ViewHost(ScriptView& view)
      : ComputingHost("a condition or text", view.now()), view_(view) {}

  script::Performed perform(script::Activation& activation,
                            const script::Effect& effect) override {
    if (effect.kind != script::EffectKind::log &&
        effect.kind != script::EffectKind::print)
      return ComputingHost::perform(activation, effect);
    view_.log(effect);
    return Value();
  }
  Value slot(TopicId topic, SlotId slot) const override {
    return view_.slot(topic, slot);
  }
  Value system(const script::Activation& activation,
               script::SystemVariable variable) const override {
    return view_.system(activation.context(), variable);
  }
  bool online(const std::string& agent) const override {
    return view_.online(agent);
  }
  double random() override {
    return view_.random();
  }
  bool watches_branches() const override {
    return view_.watches_branches();
  }
  void reached(script::Position position) override {
    view_.reached(position);
  }

private:
  ScriptView& view_;
};

} // namespace

Expected<Value> TextEvaluator::evaluate(CodeId code,
                                        const std::vector<Value>& arguments,
                                        TopicId topic) {
  ViewHost host(view_);
  script::ActivationContext context;
  context.topic = topic;
  return interpreter_.evaluate(code, arguments, std::move(context), host);
}

// Most texts are constants: for these nothing has to run.
std::string TextEvaluator::text_of(CodeId code, TopicId topic) {
  if (code == script::no_code)
    return {};
  if (auto constant = script::constant_text(*context_.program, code))
    return std::string(*constant);
  auto text = evaluate(code, {}, topic);
  if (text)
    return text->text();
  context_.inspect(InspectionKind::error, context_.topic(topic).name,
                   to_string(text.error()));
  return {};
}

Value TextEvaluator::value_of(CodeId code, TopicId topic) {
  auto value = evaluate(code, {}, topic);
  if (value)
    return *value;
  context_.inspect(InspectionKind::error, context_.topic(topic).name,
                   to_string(value.error()));
  return {};
}

Value TextEvaluator::choices_of(TopicId topic, SlotId slot) {
  const auto& taken = context_.topic(topic).slots[slot].cardinality;
  List choices;
  for (auto code : taken.values)
    choices.emplace_back(text_of(code, topic));
  Map said{{"choices", std::move(choices)}};
  if (taken.minimum != script::no_code)
    said.set("from", text_of(taken.minimum, topic));
  if (taken.maximum != script::no_code)
    said.set("to", text_of(taken.maximum, topic));
  return said;
}

bool TextEvaluator::holds(CodeId condition, const std::vector<Value>& arguments,
                          TopicId topic, TurnId turn) {
  const auto value = evaluate(condition, arguments, topic);
  if (!value)
    messenger_.script_failed(value.error(), turn);
  return value && *value;
}

} // namespace parlour::dialogue
