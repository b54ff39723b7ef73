// Grammars into an automaton: rules are put in place of their names, so a rule
// may not refer to itself; how large the result may become is limited.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "adapters/nlu/grammar/automaton.hpp"
#include "adapters/nlu/grammar/jsgf.hpp"

namespace parlour::adapters::nlu {

class AutomatonBuilder {
public:
  AutomatonBuilder(Schema& schema, std::vector<Error>& errors);

  // Its public rules; `info` is what they have in common.
  void add(const jsgf::Grammar& grammar, const RuleInfo& info);

  // One rule without a grammar around it.
  void add(const jsgf::Node& body, RuleInfo info);

  Automaton finish();

private:
  using NodeId = std::uint32_t;

  struct Empty { // a move that takes nothing
    NodeId target;
    std::uint32_t tag;
    std::int8_t does; // 1 opens the tag, -1 closes it, 0 neither
    float weight;
  };
  struct Taking {
    NodeId target;
    std::uint32_t symbol;
    bool entity;
  };
  struct Node {
    std::vector<Empty> empty;
    std::vector<Taking> taking;
    std::vector<std::uint32_t> accepts; // rules
  };

  // A path of empty moves from a state.
  struct Path {
    NodeId node;
    std::vector<Action> actions;
    float weight;
  };

  NodeId new_node(const Place& place);
  void link(NodeId from, NodeId to, float weight = 0);
  void take(NodeId from, NodeId to, std::uint32_t symbol, bool entity);
  void add_public(const jsgf::Node& body, RuleInfo info, const Place& place);

  // Each gives the node in which the part ends that begins in `from`.
  NodeId build(const jsgf::Node& node, NodeId from);
  NodeId build_untagged(const jsgf::Node& node, NodeId from);
  NodeId build_rule(const jsgf::Node& node, NodeId from);
  NodeId build_reference(const jsgf::Node& node, NodeId from);
  NodeId build_word(const jsgf::Node& node, NodeId from);
  NodeId build_sequence(const jsgf::Node& node, NodeId from);
  NodeId build_alternatives(const jsgf::Node& node, NodeId from);
  NodeId build_optional(const jsgf::Node& node, NodeId from);
  NodeId build_repeat(const jsgf::Node& node, NodeId from, bool may_be_none);
  NodeId tagged(NodeId from, NodeId inner_begin, NodeId inner_end,
                std::uint32_t tag, const Place& place);

  std::optional<std::uint32_t> add_tag(const jsgf::Tag& tag);
  std::optional<TagInfo> slot_tag(const jsgf::Tag& tag);
  void check_topic(const RuleInfo& info, std::size_t first_tag,
                   const Place& place);

  std::uint32_t state_of(NodeId node);
  void fill_state(NodeId node);
  std::uint32_t actions_of(const std::vector<Action>& actions);
  void error(const Place& place, std::string message);

  Schema& schema_;
  std::vector<Error>& errors_;
  Automaton automaton_;
  std::vector<Node> nodes_;
  std::map<std::vector<Action>, std::uint32_t> action_numbers_;
  std::vector<std::uint32_t> states_; // of nodes, once they have one
  std::vector<NodeId> waiting_;
  const jsgf::Grammar* grammar_ = nullptr;
  std::vector<const jsgf::Rule*> inside_; // rules being put in place
  std::vector<Place> tag_places_;
  std::size_t arcs_ = 0;
  bool too_large_ = false;
};

} // namespace parlour::adapters::nlu
