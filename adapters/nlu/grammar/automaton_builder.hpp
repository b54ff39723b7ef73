// AutomatonBuilder compiles grammars to an automaton in two steps:
//
//  1. Each public rule becomes nodes with empty moves (Thompson's construction,
//     automaton_builder.cpp). A reference to a rule becomes a copy of its body,
//     so a rule may not refer to itself.
//  2. Empty moves are removed (automaton_states.cpp). Each node that is reached
//     by a word or a value becomes a state, with the arcs of all nodes to which
//     empty moves lead.
//
// The size of the result is limited, since copying rules can multiply it.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "adapters/nlu/grammar/automaton.hpp"
#include "adapters/nlu/grammar/jsgf.hpp"

namespace parlour::adapters::nlu {

// Refers to both arguments of the constructor. Errors are added to `errors`
// with their place in the grammar; building goes on after an error. Not
// thread-safe.
class AutomatonBuilder {
public:
  AutomatonBuilder(Schema& schema, std::vector<Error>& errors);

  // Adds the public rules of a grammar. `info` is what they have in common.
  void add(const jsgf::Grammar& grammar, const RuleInfo& info);

  // Adds one rule that belongs to no grammar, such as an example.
  void add(const jsgf::Node& body, RuleInfo info);

  // Removes the empty moves and returns the automaton. Call it once, last.
  Automaton finish();

private:
  using NodeId = std::uint32_t;

  // A move that takes no token. It may open (1) or close (-1) a tag.
  struct Empty {
    NodeId target;
    std::uint32_t tag;
    std::int8_t does;
    float weight;
  };
  // A move that takes a word or a value.
  struct Taking {
    NodeId target;
    std::uint32_t symbol;
    bool entity;
  };
  // A node before the empty moves are removed.
  struct Node {
    std::vector<Empty> empty;
    std::vector<Taking> taking;
    // The rules that are complete here.
    std::vector<std::uint32_t> accepts;
  };

  // The empty moves on the way from a state to a node.
  struct Path {
    NodeId node;
    std::uint32_t last; // of its actions, in trail_; 0: none
    float weight;
  };
  // An action, and the one before it on the same way.
  struct Trail {
    Action action;
    std::uint32_t before;
  };

  NodeId new_node(const SourceLocation& place);
  void link(NodeId from, NodeId to, float weight = 0);
  void take(NodeId from, NodeId to, std::uint32_t symbol, bool entity);
  void add_public(const jsgf::Node& body, RuleInfo info,
                  const SourceLocation& place);

  // Each adds nodes for a part of the grammar that begins in `from`, and
  // returns the node in which it ends.
  NodeId build(const jsgf::Node& node, NodeId from);
  NodeId build_untagged(const jsgf::Node& node, NodeId from);
  NodeId build_rule(const jsgf::Node& node, NodeId from);
  NodeId build_reference(const jsgf::Node& node, NodeId from);
  NodeId build_word(const jsgf::Node& node, NodeId from);
  NodeId build_sequence(const jsgf::Node& node, NodeId from);
  NodeId build_alternatives(const jsgf::Node& node, NodeId from);
  NodeId build_optional(const jsgf::Node& node, NodeId from);
  NodeId build_repeat(const jsgf::Node& node, NodeId from, bool may_be_none);
  // Puts a tag around the nodes from `inner_begin` to `inner_end`.
  NodeId tagged(NodeId from, NodeId inner_begin, NodeId inner_end,
                std::uint32_t tag, const SourceLocation& place);

  std::optional<std::uint32_t> add_tag(const jsgf::Tag& tag);
  // Equal tags share one number.
  std::uint32_t number_of(TagInfo tag, const SourceLocation& place);
  std::optional<TagInfo> slot_tag(const jsgf::Tag& tag);
  std::string no_such_slot(const jsgf::Tag& tag) const;
  // Reports a slot that does not belong to the rule's topic.
  void check_topic(const RuleInfo& info);

  // The state of a node, new if it has none yet.
  std::uint32_t state_of(NodeId node);
  void fill_state(NodeId node);
  // Equal lists of actions share one number.
  std::uint32_t actions_of(const Path& path);
  void error(const SourceLocation& place, std::string message);

  Schema& schema_;
  std::vector<Error>& errors_;
  Automaton automaton_;
  std::vector<Node> nodes_;
  std::map<std::vector<Action>, std::uint32_t> action_numbers_;
  // By node; no_state if it has none.
  std::vector<std::uint32_t> states_;
  // The actions of all ways from the node whose state is filled.
  std::vector<Trail> trail_;
  // By node: the last state whose ways led there.
  std::vector<std::uint32_t> seen_;
  // Nodes whose state has no arcs yet.
  std::vector<NodeId> waiting_;
  const jsgf::Grammar* grammar_ = nullptr;
  // The rules that are being copied, to find one that refers to itself.
  std::vector<const jsgf::Rule*> inside_;
  // By kind, name, topic and value.
  std::map<std::tuple<TagKind, std::string, TopicNumber, std::string>,
           std::uint32_t>
      tag_numbers_;
  // Of the rule that is being added: its tags, and where they stand.
  std::vector<std::pair<std::uint32_t, SourceLocation>> own_tags_;
  std::size_t arcs_ = 0;
  bool too_large_ = false;
  // Whether the rule that is being added is the platform's.
  bool generic_ = false;
};

} // namespace parlour::adapters::nlu
