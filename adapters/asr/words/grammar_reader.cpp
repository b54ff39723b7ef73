#include "adapters/asr/words/grammar_reader.hpp"

#include <algorithm>
#include <array>

#include "adapters/asr/words/spoken_words.hpp"

namespace parlour::adapters::asr {

using nlu::jsgf::NodeKind;

namespace {

// The slot that a node's tags fill: the last part of {Topic.Slot}.
// {act=request} and {topic=Facility} fill no slot.
std::string slot_of(const nlu::jsgf::Node& node) {
  for (const auto& tag : node.tags)
    if (!tag.has_value && tag.name != "act" && tag.name != "topic")
      return tag.name.substr(tag.name.rfind('.') + 1);
  return {};
}

// Whether the node's words name a value: a slot or column, or a tag with a
// value of its own.
bool names_value(const nlu::jsgf::Node& node) {
  return (node.kind == NodeKind::reference &&
          node.text.find('.') != std::string::npos) ||
         std::ranges::any_of(node.tags, [](const nlu::jsgf::Tag& tag) {
           return tag.has_value && tag.name != "act" && tag.name != "topic";
         });
}

constexpr std::array determiners{"a", "an", "the", "any", "some"};

} // namespace

void GrammarReader::add(const nlu::jsgf::Grammar& grammar, GraphBuilder& to) {
  to_ = &to;
  grammar_ = &grammar;
  for (const auto& rule : grammar.rules)
    if (rule.is_public) {
      inside_ = {&rule};
      to.accept(build(rule.body, GraphBuilder::start));
    }
  inside_.clear();
}

void GrammarReader::add(const Node& node, GraphBuilder& to) {
  to_ = &to;
  grammar_ = nullptr;
  to.accept(build(node, GraphBuilder::start));
}

// Each form goes into the builder of its own value set.
void GrammarReader::add_forms(const nlu::jsgf::Grammar& grammar) {
  grammar_ = &grammar;
  is_form_ = true;
  for (const auto& rule : grammar.rules)
    if (rule.is_public) {
      to_ = &sets_.builder(sets_.form(rule.name));
      inside_ = {&rule};
      to_->accept(build(rule.body, GraphBuilder::start));
    }
  inside_.clear();
  is_form_ = false;
}

// Where the builder is full, what is left adds nothing.
GrammarReader::State GrammarReader::build(const Node& node, State from) {
  if (to_->is_full())
    return from;
  if (names_value(node))
    from = build_determiner(from);
  const auto slot = slot_of(node);
  if (!slot.empty())
    slots_.push_back(slot);
  auto end = from;
  switch (node.kind) {
  case NodeKind::word:
    end = build_word(node, from);
    break;
  case NodeKind::rule:
    end = build_rule(node, from);
    break;
  case NodeKind::reference:
    end = build_reference(node, from);
    break;
  case NodeKind::sequence:
    for (const auto& child : node.children)
      end = build(child, end);
    break;
  case NodeKind::alternatives:
    end = build_alternatives(node, from);
    break;
  case NodeKind::optional:
    end = build_alternatives(node, from);
    to_->link(from, end);
    break;
  case NodeKind::star:
  case NodeKind::plus:
    end = build_repeat(node, from, node.kind == NodeKind::star);
    break;
  case NodeKind::nothing:
    break;
  case NodeKind::never:
    end = to_->add(); // nothing leads there
    break;
  }
  if (!slot.empty())
    slots_.pop_back();
  return end;
}

// The understanding lets them stand before any value; so do people.
GrammarReader::State GrammarReader::build_determiner(State from) {
  const auto next = to_->add();
  to_->link(from, next);
  for (const auto* const word : determiners)
    to_->take(from, next, symbols_.word(word));
  return next;
}

// A word of a grammar may be several that are said, as "10:30" is.
GrammarReader::State GrammarReader::build_word(const Node& node, State from) {
  auto words = spoken_words(node.text);
  spellings_.note(node.text, false);
  for (auto& word : words) {
    if (is_form_ && (word == "am" || word == "pm"))
      word = word == "am" ? "a.m." : "p.m.";
    if (word == "oclock")
      word = "o'clock";
    const auto next = to_->add();
    to_->take(from, next, symbols_.word(word));
    from = next;
  }
  return from;
}

// A state that nothing leads to: what follows the missing rule cannot be said.
GrammarReader::State GrammarReader::build_rule(const Node& node, State from) {
  const nlu::jsgf::Rule* found = nullptr;
  if (grammar_)
    for (const auto& rule : grammar_->rules)
      if (rule.name == node.text)
        found = &rule;
  if (!found || std::ranges::find(inside_, found) != inside_.end())
    return to_->add();
  inside_.push_back(found);
  const auto end = build(found->body, from);
  inside_.pop_back();
  return end;
}

// What the last question asked for is said alone, too (Language): nothing is
// known of it here.
GrammarReader::State GrammarReader::build_reference(const Node& node,
                                                    State from) {
  const auto end = to_->add();
  if (node.text != "asked")
    to_->take(from, end,
              sets_.set_of(node.text, slots_.empty() ? "" : slots_.back()));
  return end;
}

GrammarReader::State GrammarReader::build_alternatives(const Node& node,
                                                       State from) {
  const auto end = to_->add();
  for (const auto& child : node.children)
    to_->link(build(child, from), end);
  return end;
}

// "very very good": the way back leads to the state before the words.
GrammarReader::State GrammarReader::build_repeat(const Node& node, State from,
                                                 bool may_be_none) {
  const auto begin = to_->add();
  to_->link(from, begin);
  auto at = begin;
  for (const auto& child : node.children)
    at = build(child, at);
  const auto end = to_->add();
  to_->link(at, end);
  to_->link(at, begin);
  if (may_be_none)
    to_->link(begin, end);
  return end;
}

} // namespace parlour::adapters::asr
