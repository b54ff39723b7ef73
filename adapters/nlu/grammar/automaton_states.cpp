// Follows the empty moves between nodes and leaves states that have none.
#include <algorithm>
#include <ranges>
#include <set>

#include "adapters/nlu/grammar/automaton_builder.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t most_arcs = 1'000'000;
constexpr std::uint32_t no_state = 0xFFFFFFFF;

} // namespace

std::span<const Arc> arcs_of(const std::vector<Arc>& arcs,
                             std::uint32_t symbol) {
  const auto range = std::ranges::equal_range(arcs, symbol, {}, &Arc::symbol);
  return {range.begin(), range.end()};
}

Automaton AutomatonBuilder::finish() {
  states_.assign(nodes_.size(), no_state);
  state_of(0);
  while (!waiting_.empty() && !too_large_) {
    const auto node = waiting_.back();
    waiting_.pop_back();
    fill_state(node);
  }
  for (const auto& state : automaton_.states)
    for (const auto& arc : state.entities)
      automaton_.entities.push_back(arc.symbol);
  auto& entities = automaton_.entities;
  std::ranges::sort(entities);
  entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
  return std::move(automaton_);
}

std::uint32_t AutomatonBuilder::state_of(NodeId node) {
  if (states_[node] == no_state) {
    states_[node] = static_cast<std::uint32_t>(automaton_.states.size());
    automaton_.states.emplace_back();
    waiting_.push_back(node);
  }
  return states_[node];
}

// Follows the empty moves from a node; each node is reached once, by the first
// way, which also ends loops of parts that may be empty.
void AutomatonBuilder::fill_state(NodeId node) {
  const auto number = states_[node];
  State state;
  std::vector<Path> paths{{node, {}, 0}};
  std::set<NodeId> seen{node};
  while (!paths.empty()) {
    const auto path = std::move(paths.back());
    paths.pop_back();
    const auto& here = nodes_[path.node];
    const auto actions = actions_of(path.actions);
    for (const auto rule : here.accepts)
      state.accepts.push_back({rule, actions, path.weight});
    for (const auto& move : here.taking) {
      auto& arcs = move.entity ? state.entities : state.words;
      arcs.push_back(
          {move.symbol, actions, state_of(move.target), path.weight});
    }
    // Backwards, so that what the grammar says first is followed first.
    for (const auto& move : std::views::reverse(here.empty)) {
      if (!seen.insert(move.target).second)
        continue;
      paths.push_back({move.target, path.actions, path.weight + move.weight});
      if (move.does != 0)
        paths.back().actions.push_back({move.tag, move.does > 0});
    }
  }
  std::ranges::stable_sort(state.words, {}, &Arc::symbol);
  arcs_ += state.words.size() + state.entities.size();
  if (arcs_ > most_arcs && !std::exchange(too_large_, true))
    error({}, "the grammars are too large together: more than " +
                  std::to_string(most_arcs) + " arcs");
  automaton_.states[number] = std::move(state);
}

std::uint32_t AutomatonBuilder::actions_of(const std::vector<Action>& actions) {
  const auto next = static_cast<std::uint32_t>(automaton_.actions.size());
  const auto [place, is_new] = action_numbers_.try_emplace(actions, next);
  if (is_new)
    automaton_.actions.push_back(actions);
  return place->second;
}

} // namespace parlour::adapters::nlu
