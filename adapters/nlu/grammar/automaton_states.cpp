// The second step of AutomatonBuilder: removes the empty moves.
#include <algorithm>
#include <utility>

#include "adapters/nlu/grammar/automaton_builder.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t max_arcs = 1'000'000;
constexpr std::uint32_t no_state = 0xFFFFFFFF;

} // namespace

std::span<const Arc> arcs_of(const std::vector<Arc>& arcs,
                             std::uint32_t symbol) {
  const auto first = std::ranges::lower_bound(arcs, symbol, {}, &Arc::symbol);
  auto last = first;
  while (last != arcs.end() && last->symbol == symbol)
    ++last;
  return {first, last};
}

// Only nodes that can be reached become states.
Automaton AutomatonBuilder::finish() {
  states_.assign(nodes_.size(), no_state);
  seen_.assign(nodes_.size(), no_state);
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

// Collects the arcs of a state: of every node that empty moves lead to from its
// node, with the tags that open and close on the way. Depth first; each node is
// visited once, by the first way, which also ends loops of parts that may be
// empty.
void AutomatonBuilder::fill_state(NodeId node) {
  const auto number = states_[node];
  State state;
  std::vector<Path> paths{{node, 0, 0}};
  trail_.assign(1, {});
  seen_[node] = number;
  while (!paths.empty()) {
    const auto path = paths.back();
    paths.pop_back();
    const auto& here = nodes_[path.node];
    const bool has_arcs = !here.accepts.empty() || !here.taking.empty();
    const auto actions = has_arcs ? actions_of(path) : 0;
    for (const auto rule : here.accepts)
      state.accepts.push_back({rule, actions, path.weight});
    for (const auto& move : here.taking) {
      auto& arcs = move.entity ? state.entities : state.words;
      arcs.push_back(
          {move.symbol, actions, state_of(move.target), path.weight});
    }
    // `paths` is a stack: pushing in reverse order visits the grammar's first
    // alternative first.
    for (auto move = here.empty.rbegin(); move != here.empty.rend(); ++move) {
      if (std::exchange(seen_[move->target], number) == number)
        continue;
      paths.push_back({move->target, path.last, path.weight + move->weight});
      if (move->does == 0)
        continue;
      paths.back().last = static_cast<std::uint32_t>(trail_.size());
      trail_.push_back({{move->tag, move->does > 0}, path.last});
    }
  }
  std::ranges::stable_sort(state.words, {}, &Arc::symbol);
  for (const auto& arc : state.words)
    state.word_bits |= word_bit(arc.symbol);
  for (const auto& arc : state.entities)
    state.entity_bits |= entity_bit(arc.symbol);
  arcs_ += state.words.size() + state.entities.size();
  if (arcs_ > max_arcs && !std::exchange(too_large_, true))
    error({}, "the grammars are too large together: more than " +
                  std::to_string(max_arcs) + " arcs");
  automaton_.states[number] = std::move(state);
}

std::uint32_t AutomatonBuilder::actions_of(const Path& path) {
  std::vector<Action> actions;
  for (auto at = path.last; at != 0; at = trail_[at].before)
    actions.push_back(trail_[at].action);
  std::ranges::reverse(actions);
  const auto next = static_cast<std::uint32_t>(automaton_.actions.size());
  const auto [place, is_new] = action_numbers_.try_emplace(actions, next);
  if (is_new)
    automaton_.actions.push_back(std::move(actions));
  return place->second;
}

} // namespace parlour::adapters::nlu
