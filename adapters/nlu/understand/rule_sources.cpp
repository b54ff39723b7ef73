#include "adapters/nlu/understand/rule_sources.hpp"

#include <utility>

#include "adapters/nlu/grammar/examples.hpp"

namespace parlour::adapters::nlu {

namespace {

// What a bare value, and a part of an example, lose against a whole sentence.
constexpr float bare_bias = -0.3F;
constexpr float part_bias = -0.2F;
// A grammar that is named like a topic is about it.
void add_grammars(AutomatonBuilder& builder, const Schema& schema,
                  const std::vector<GrammarModel>& grammars, bool generic,
                  std::vector<Error>& errors) {
  for (const auto& model : grammars) {
    RuleInfo info;
    info.generic = generic;
    info.topic = schema.topic(model.name);
    builder.add(jsgf::parse(model, errors), info);
  }
}

// Adds {act=…} to a rule.
jsgf::Node with_act(jsgf::Node node, std::string act) {
  node.tags.push_back({"act", std::move(act), true, {}});
  return node;
}

// More examples are learnt only. As rules they would make every utterance slow.
constexpr std::size_t max_example_rules = 500;

// Few examples also become rules.
bool become_rules(const std::vector<TopicModel>& topics) {
  std::size_t examples = 0;
  for (const auto& topic : topics)
    examples += topic.examples.size();
  return examples <= max_example_rules;
}

// Reports the slots of an example that do not exist; as a rule, the builder
// does it.
void check_slots(const jsgf::Node& whole, Schema& schema,
                 std::vector<Error>& errors) {
  for (const auto& part : whole.children)
    if (part.kind == jsgf::NodeKind::reference)
      // Only the errors matter here.
      schema.resolve(part.text, {}, errors);
}

void add_examples(AutomatonBuilder& builder, Schema& schema,
                  const std::vector<TopicModel>& topics,
                  std::vector<Error>& errors) {
  const bool as_rules = become_rules(topics);
  for (const auto& topic : topics) {
    RuleInfo info;
    info.topic = schema.topic(topic.name);
    for (const auto& example : topic.examples) {
      auto rules = example_rules(topic, example, errors);
      if (!as_rules) {
        check_slots(rules.whole, schema, errors);
        continue;
      }
      info.name = "\"" + example + "\"";
      info.bias = 0;
      builder.add(
          with_act(std::move(rules.whole), schema.at(info.topic).usual_act()),
          info);
      info.bias = part_bias;
      for (const auto& part : rules.parts)
        builder.add(part, info);
    }
  }
}

// Adds a rule for each slot, since its value may be said alone.
void add_bare_values(AutomatonBuilder& builder, const Schema& schema) {
  for (const auto& topic : schema.topics()) {
    for (const auto& slot : topic.slots) {
      if (slot.entity == words_entity)
        continue;
      const auto reference = topic.name + '.' + slot.name;
      RuleInfo info;
      info.name = "<@" + reference + ">";
      info.topic = schema.topic(topic.name);
      info.bare = true;
      info.bias = bare_bias;
      builder.add({jsgf::NodeKind::reference, reference, {}, {}, {}, {}}, info);
    }
  }
}

} // namespace

void add_rules(const UnderstandingModel& model,
               const std::vector<GrammarModel>& generic, Schema& schema,
               AutomatonBuilder& builder, std::vector<Error>& errors) {
  add_grammars(builder, schema, generic, true, errors);
  add_grammars(builder, schema, model.grammars, false, errors);
  add_examples(builder, schema, model.topics, errors);
  add_bare_values(builder, schema);
}

} // namespace parlour::adapters::nlu
