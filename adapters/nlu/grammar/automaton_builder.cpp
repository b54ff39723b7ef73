// The first step of AutomatonBuilder. Each build function extends the graph
// from a node and returns the node at the end of the new part. Sequences thus
// chain, alternatives fan out from one node and meet in another:
//
//  from --(weight)--> begin ... end_of_child --> end
#include "adapters/nlu/grammar/automaton_builder.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "adapters/nlu/text/similarity.hpp"
#include "adapters/nlu/text/words.hpp"
#include "runtime/message/act_kinds.hpp"

namespace parlour::adapters::nlu {

namespace {

// Bounds the memory and the time of loading.
constexpr std::size_t max_nodes = 200'000;

// Whether one of the node's tags names a slot.
bool fills_slot(const jsgf::Node& node) {
  return std::ranges::any_of(node.tags, [](const jsgf::Tag& tag) {
    return tag.name != "act" && tag.name != "topic" && tag.name != "denies";
  });
}

} // namespace

AutomatonBuilder::AutomatonBuilder(Schema& schema, std::vector<Error>& errors)
    : schema_(schema), errors_(errors) {
  // Node 0 is the common start of all rules; list 0 of actions is empty.
  nodes_.emplace_back();
  automaton_.actions.emplace_back();
  action_numbers_[{}] = 0;
}

void AutomatonBuilder::error(const SourceLocation& place, std::string message) {
  errors_.push_back({ErrorKind::compile, std::move(message), place});
}

void AutomatonBuilder::add(const jsgf::Grammar& grammar, const RuleInfo& info) {
  grammar_ = &grammar;
  // Rules that are not public are only copied where they are referred to.
  bool any = false;
  for (const auto& rule : grammar.rules) {
    if (!rule.is_public)
      continue;
    any = true;
    auto own = info;
    own.grammar = grammar.name;
    own.name = "<" + grammar.name + "." + rule.name + ">";
    inside_ = {&rule};
    add_public(rule.body, std::move(own), rule.place);
    inside_.clear();
  }
  if (!any && !grammar.rules.empty())
    error(grammar.rules[0].place, "the grammar '" + grammar.name +
                                      "' has no public rule, so nothing of it "
                                      "is ever tried");
  grammar_ = nullptr;
}

void AutomatonBuilder::add(const jsgf::Node& body, RuleInfo info) {
  add_public(body, std::move(info), body.place);
}

// All rules start in node 0; the node at the end of a rule accepts it.
void AutomatonBuilder::add_public(const jsgf::Node& body, RuleInfo info,
                                  const SourceLocation& place) {
  const auto rule = static_cast<std::uint32_t>(automaton_.rules.size());
  own_tags_.clear();
  generic_ = info.generic;
  const auto begin = new_node(place);
  link(0, begin);
  nodes_[build(body, begin)].accepts.push_back(rule);
  check_topic(info);
  automaton_.rules.push_back(std::move(info));
}

// When the limit is reached the error is reported once. Node 0 then stands in
// for every new node, and the result is not used.
AutomatonBuilder::NodeId
AutomatonBuilder::new_node(const SourceLocation& place) {
  if (nodes_.size() >= max_nodes) {
    if (!std::exchange(too_large_, true))
      error(place, "the grammars are too large together; is a rule of many "
                   "alternatives used many times?");
    return 0;
  }
  nodes_.emplace_back();
  return static_cast<NodeId>(nodes_.size() - 1);
}

void AutomatonBuilder::link(NodeId from, NodeId to, float weight) {
  nodes_[from].empty.push_back({to, 0, 0, weight});
}

void AutomatonBuilder::take(NodeId from, NodeId to, std::uint32_t symbol,
                            bool entity) {
  nodes_[from].taking.push_back({to, symbol, entity});
}

// A node with tags: the first tag is the innermost one. A tag with an error is
// ignored.
AutomatonBuilder::NodeId AutomatonBuilder::build(const jsgf::Node& node,
                                                 NodeId from) {
  if (too_large_)
    return from;
  if (node.tags.empty())
    return build_untagged(node, from);
  const auto inner = new_node(node.place);
  auto begin = inner;
  auto end = build_untagged(node, inner);
  // Each tag encloses what has been built so far.
  for (const auto& tag : node.tags) {
    const auto number = add_tag(tag);
    if (!number)
      continue;
    const auto outer = new_node(tag.place);
    end = tagged(outer, begin, end, *number, tag.place);
    begin = outer;
  }
  link(from, begin);
  return end;
}

AutomatonBuilder::NodeId
AutomatonBuilder::tagged(NodeId from, NodeId inner_begin, NodeId inner_end,
                         std::uint32_t tag, const SourceLocation& place) {
  const auto end = new_node(place);
  nodes_[from].empty.push_back({inner_begin, tag, 1, 0});
  nodes_[inner_end].empty.push_back({end, tag, -1, 0});
  return end;
}

AutomatonBuilder::NodeId
AutomatonBuilder::build_untagged(const jsgf::Node& node, NodeId from) {
  switch (node.kind) {
  case jsgf::NodeKind::word:
    return build_word(node, from);
  case jsgf::NodeKind::rule:
    return build_rule(node, from);
  case jsgf::NodeKind::reference:
    return build_reference(node, from);
  case jsgf::NodeKind::sequence:
    return build_sequence(node, from);
  case jsgf::NodeKind::alternatives:
    return build_alternatives(node, from);
  case jsgf::NodeKind::optional:
    return build_optional(node, from);
  case jsgf::NodeKind::star:
  case jsgf::NodeKind::plus:
    return build_repeat(node, from, node.kind == jsgf::NodeKind::star);
  // Matches without a word.
  case jsgf::NodeKind::nothing:
    return from;
  // A node without a way to it matches nothing.
  case jsgf::NodeKind::never:
    return new_node(node.place);
  }
  return from;
}

// Words are numbered from 1 in the order in which they occur.
AutomatonBuilder::NodeId AutomatonBuilder::build_word(const jsgf::Node& node,
                                                      NodeId from) {
  const auto next = static_cast<WordNumber>(automaton_.vocabulary.size() + 1);
  const auto place = automaton_.vocabulary.try_emplace(node.text, next).first;
  const auto end = new_node(node.place);
  take(from, end, place->second, false);
  if (!generic_ && is_hesitation(node.text))
    automaton_.own_hesitations.insert(node.text);
  return end;
}

// Copies the body of the rule to this place.
AutomatonBuilder::NodeId AutomatonBuilder::build_rule(const jsgf::Node& node,
                                                      NodeId from) {
  if (!grammar_)
    return from;
  const auto found =
      std::ranges::find(grammar_->rules, node.text, &jsgf::Rule::name);
  if (found == grammar_->rules.end()) {
    std::vector<std::string> names;
    for (const auto& rule : grammar_->rules)
      names.push_back(rule.name);
    error(node.place, "there is no rule <" + node.text + ">" +
                          did_you_mean(node.text, names));
    return from;
  }
  if (std::ranges::find(inside_, &*found) != inside_.end()) {
    error(node.place, "the rule <" + node.text +
                          "> refers to itself; use * or + to repeat");
    return from;
  }
  inside_.push_back(&*found);
  const auto end = build(found->body, from);
  inside_.pop_back();
  return end;
}

// A value of an entity. A reference to a slot fills that slot, unless a tag
// behind it names another one.
AutomatonBuilder::NodeId
AutomatonBuilder::build_reference(const jsgf::Node& node, NodeId from) {
  const auto reference = schema_.resolve(node.text, node.place, errors_);
  if (!reference)
    return from;
  const auto begin = new_node(node.place);
  const auto end = new_node(node.place);
  take(begin, end, reference->entity, true);
  const bool asked = reference->entity == asked_entity;
  if (!asked && (reference->topic == no_topic || fills_slot(node))) {
    link(from, begin);
    return end;
  }
  TagInfo tag{asked ? TagKind::asked : TagKind::slot,
              reference->slot,
              reference->topic,
              false,
              {}};
  return tagged(from, begin, end, number_of(std::move(tag), node.place),
                node.place);
}

AutomatonBuilder::NodeId
AutomatonBuilder::build_sequence(const jsgf::Node& node, NodeId from) {
  for (const auto& child : node.children)
    from = build(child, from);
  return from;
}

AutomatonBuilder::NodeId
AutomatonBuilder::build_alternatives(const jsgf::Node& node, NodeId from) {
  const auto end = new_node(node.place);
  const auto most = std::ranges::max(node.weights);
  for (std::size_t at = 0; at < node.children.size(); ++at) {
    const auto begin = new_node(node.place);
    // Weights are relative to the largest one. A factor of two costs 0.1 of the
    // score, a tenth of a word.
    const auto weight = 0.1 * std::log2(node.weights[at] / most);
    link(from, begin, static_cast<float>(weight));
    link(build(node.children[at], begin), end);
  }
  return end;
}

// The part, or an empty move past it.
AutomatonBuilder::NodeId
AutomatonBuilder::build_optional(const jsgf::Node& node, NodeId from) {
  const auto begin = new_node(node.place);
  link(from, begin);
  const auto end = new_node(node.place);
  link(build(node.children[0], begin), end);
  link(from, end);
  return end;
}

// As build_optional, with a move back to the beginning. The move past the part
// exists only for `*`.
AutomatonBuilder::NodeId AutomatonBuilder::build_repeat(const jsgf::Node& node,
                                                        NodeId from,
                                                        bool may_be_none) {
  const auto begin = new_node(node.place);
  link(from, begin);
  const auto inner = build(node.children[0], begin);
  const auto end = new_node(node.place);
  link(inner, end);
  // Back to the beginning: the part may follow itself.
  link(inner, begin);
  if (may_be_none)
    link(from, end);
  return end;
}

// Returns the number of the tag, or nothing after an error. Everything but
// {act=…}, {topic=…} and {denies=next} names a slot.
std::optional<std::uint32_t> AutomatonBuilder::add_tag(const jsgf::Tag& tag) {
  std::optional<TagInfo> made;
  if (tag.name == "act" && tag.has_value) {
    made = TagInfo{TagKind::act, tag.value, no_topic, false, {}};
    if (std::ranges::find(act_names(), tag.value) == act_names().end())
      error(tag.place, "there is no act '" + tag.value + "'" +
                           did_you_mean(tag.value, act_names()));
  } else if (tag.name == "topic" && tag.has_value) {
    made = TagInfo{TagKind::topic, "", schema_.topic(tag.value), false, {}};
    if (made->topic == no_topic)
      error(tag.place, "there is no topic '" + tag.value + "'" +
                           did_you_mean(tag.value, schema_.topic_names()));
  } else if (tag.name == "denies" && tag.value == "next") {
    made = TagInfo{TagKind::denies, "", no_topic, false, {}};
  } else {
    made = slot_tag(tag);
  }
  if (!made)
    return {};
  return number_of(std::move(*made), tag.place);
}

std::uint32_t AutomatonBuilder::number_of(TagInfo tag,
                                          const SourceLocation& place) {
  const auto next = static_cast<std::uint32_t>(automaton_.tags.size());
  const auto value = tag.has_value ? to_string(tag.value) : "";
  const auto [found, is_new] =
      tag_numbers_.try_emplace({tag.kind, tag.name, tag.topic, value}, next);
  if (is_new)
    automaton_.tags.push_back(std::move(tag));
  own_tags_.emplace_back(found->second, place);
  return found->second;
}

// A tag that is no slot may be another kind of tag with a wrong value.
std::string AutomatonBuilder::no_such_slot(const jsgf::Tag& tag) const {
  if (tag.name == "act" || tag.name == "topic")
    return "the tag {" + tag.name + "} needs a value: {" + tag.name + "=…}";
  if (tag.name == "denies")
    return "what can be denied is the next words: {denies=next}";
  return "no topic has a slot '" + tag.name + "'" +
         did_you_mean(tag.name, schema_.slot_names(no_topic));
}

// {Slot} may belong to any topic that has it; {Topic.Slot} names one.
std::optional<TagInfo> AutomatonBuilder::slot_tag(const jsgf::Tag& tag) {
  TagInfo made{TagKind::slot, tag.name, no_topic, tag.has_value,
               tag.has_value ? jsgf::literal(tag.value) : Value()};
  if (const auto point = tag.name.find('.'); point != std::string::npos) {
    const auto reference = schema_.resolve(tag.name, tag.place, errors_);
    if (!reference)
      return {};
    made.topic = reference->topic;
    made.name = reference->slot;
  } else if (schema_.topics_with(tag.name).empty()) {
    error(tag.place, no_such_slot(tag));
    return {};
  }
  return made;
}

// A rule that is about one topic only may fill slots of that topic only.
void AutomatonBuilder::check_topic(const RuleInfo& info) {
  std::set<TopicNumber> topics;
  if (info.topic != no_topic)
    topics.insert(info.topic);
  for (const auto& [number, place] : own_tags_)
    if (automaton_.tags[number].topic != no_topic)
      topics.insert(automaton_.tags[number].topic);
  // With several topics, or none, a slot may belong to any of them.
  if (topics.size() != 1)
    return;
  const auto& topic = schema_.at(*topics.begin());
  for (const auto& [number, place] : own_tags_) {
    const auto& tag = automaton_.tags[number];
    if (tag.kind == TagKind::slot && !topic.find(tag.name))
      error(place,
            "the topic '" + topic.name + "' has no slot '" + tag.name + "'" +
                did_you_mean(tag.name, schema_.slot_names(*topics.begin())));
  }
}

} // namespace parlour::adapters::nlu
