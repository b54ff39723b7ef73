// Subset construction, then refinement of a partition (Moore).
#include "adapters/asr/words/word_graph.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace parlour::adapters::asr {

Symbol Symbols::word(std::string_view text) {
  return number(text, false);
}

Symbol Symbols::value_set(std::string_view name) {
  return number(name, true);
}

Symbol Symbols::number(std::string_view text, bool is_set) {
  const auto [found, is_new] = numbers_.try_emplace(
      {is_set, std::string(text)}, static_cast<Symbol>(texts_.size()));
  if (is_new) {
    texts_.emplace_back(text);
    is_set_.push_back(is_set);
  }
  return found->second;
}

std::size_t WordGraph::arc_count() const {
  std::size_t count = 0;
  for (const auto& state : states)
    count += state.arcs.size();
  return count;
}

GraphBuilder::GraphBuilder(std::size_t most_states)
    : most_states_(most_states), nodes_(1) {}

GraphBuilder::State GraphBuilder::add() {
  if (nodes_.size() >= most_states_) {
    is_full_ = true;
    return static_cast<State>(nodes_.size() - 1);
  }
  nodes_.emplace_back();
  return static_cast<State>(nodes_.size() - 1);
}

void GraphBuilder::link(State from, State to) {
  if (!is_full_)
    nodes_[from].empty.push_back(to);
}

void GraphBuilder::take(State from, State to, Symbol symbol) {
  if (!is_full_)
    nodes_[from].arcs.push_back({symbol, to});
}

void GraphBuilder::accept(State state) {
  if (!is_full_)
    nodes_[state].is_final = true;
}

void GraphBuilder::add_sentence(const std::vector<Symbol>& sentence) {
  if (sentence.empty())
    return;
  auto at = start;
  for (const auto symbol : sentence) {
    const auto next = add();
    take(at, next, symbol);
    at = next;
  }
  accept(at);
}

// Empty moves may lie between the two words.
//
//   0 -i-> 1 -am-> 2    gets    0 -i'm-> 2
void GraphBuilder::contract(Symbol first, Symbol second, Symbol both) {
  for (auto& node : nodes_) {
    std::vector<State> ends;
    for (const auto& arc : node.arcs)
      if (arc.symbol == first)
        for (const auto behind : closure({arc.target}))
          for (const auto& next : nodes_[behind].arcs)
            if (next.symbol == second)
              ends.push_back(next.target);
    for (const auto end : ends)
      node.arcs.push_back({both, end});
  }
}

// The states that empty moves lead to, sorted.
std::vector<GraphBuilder::State>
GraphBuilder::closure(std::vector<State> states) const {
  for (std::size_t at = 0; at < states.size(); ++at)
    for (const auto next : nodes_[states[at]].empty)
      if (std::ranges::find(states, next) == states.end())
        states.push_back(next);
  std::ranges::sort(states);
  states.erase(std::unique(states.begin(), states.end()), states.end());
  return states;
}

// A state of the result is a set of states of the builder; each set is numbered
// when it is met first.
WordGraph GraphBuilder::deterministic(std::size_t most_states) const {
  WordGraph graph;
  std::map<std::vector<State>, std::uint32_t> numbers;
  std::vector<const std::vector<State>*> sets;
  auto number_of = [&](std::vector<State> set) {
    const auto [found, is_new] = numbers.try_emplace(
        std::move(set), static_cast<std::uint32_t>(sets.size()));
    if (is_new)
      sets.push_back(&found->first);
    return found->second;
  };
  number_of(closure({start}));
  for (std::size_t at = 0; at < sets.size(); ++at) {
    WordGraph::State made;
    std::map<Symbol, std::vector<State>> targets;
    for (const auto state : *sets[at]) {
      made.is_final |= nodes_[state].is_final;
      for (const auto& arc : nodes_[state].arcs)
        targets[arc.symbol].push_back(arc.target);
    }
    for (auto& [symbol, states] : targets) {
      if (sets.size() >= most_states) {
        is_full_ = true;
        break;
      }
      made.arcs.push_back({symbol, number_of(closure(std::move(states)))});
    }
    graph.states.push_back(std::move(made));
  }
  return graph;
}

namespace {

// Which states lead to the end of a sentence.
std::vector<bool> living_states(const WordGraph& graph) {
  std::vector<std::vector<std::uint32_t>> sources(graph.states.size());
  std::vector<std::uint32_t> living;
  for (std::uint32_t i = 0; i < graph.states.size(); ++i) {
    if (graph.states[i].is_final)
      living.push_back(i);
    for (const auto& arc : graph.states[i].arcs)
      sources[arc.target].push_back(i);
  }
  std::vector<bool> lives(graph.states.size());
  for (const auto state : living)
    lives[state] = true;
  for (std::size_t at = 0; at < living.size(); ++at)
    for (const auto source : sources[living[at]])
      if (!lives[source]) {
        lives[source] = true;
        living.push_back(source);
      }
  return lives;
}

// Leaves out what begins no sentence; the first state stays.
WordGraph without_dead_ends(const WordGraph& graph) {
  const auto lives = living_states(graph);
  std::vector<std::uint32_t> numbers(graph.states.size());
  std::uint32_t count = 1;
  for (std::size_t i = 1; i < numbers.size(); ++i)
    if (lives[i])
      numbers[i] = count++;
  WordGraph made;
  made.states.resize(count);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i != 0 && !lives[i])
      continue;
    auto& state = made.states[numbers[i]];
    state.is_final = graph.states[i].is_final;
    for (const auto& arc : graph.states[i].arcs)
      if (lives[arc.target])
        state.arcs.push_back({arc.symbol, numbers[arc.target]});
  }
  return made;
}

} // namespace

// Dead ends go first: they would keep states apart that are the same without
// them.
WordGraph GraphBuilder::finish() const {
  return minimal(without_dead_ends(deterministic(most_states_)));
}

// States are told apart step by step: first the final ones from the others,
// then by where their arcs lead, until nothing changes.
WordGraph minimal(const WordGraph& graph) {
  const auto count = graph.states.size();
  std::vector<std::uint32_t> part(count);
  for (std::size_t i = 0; i < count; ++i)
    part[i] = graph.states[i].is_final;
  std::size_t parts = 0;
  // What tells states apart: their part, and where their arcs lead.
  using Signature = std::pair<std::uint32_t, std::vector<WordGraph::Arc>>;
  for (;;) {
    std::map<Signature, std::uint32_t> numbers;
    std::vector<std::uint32_t> next(count);
    for (std::size_t i = 0; i < count; ++i) {
      Signature signature{part[i], graph.states[i].arcs};
      for (auto& arc : signature.second)
        arc.target = part[arc.target];
      // Numbered in the order of the states, so that state 0 stays the first.
      next[i] = numbers
                    .try_emplace(std::move(signature),
                                 static_cast<std::uint32_t>(numbers.size()))
                    .first->second;
    }
    part = std::move(next);
    if (numbers.size() == parts)
      break;
    parts = numbers.size();
  }
  WordGraph made;
  made.states.resize(parts);
  for (std::size_t i = 0; i < count; ++i) {
    auto& state = made.states[part[i]];
    state = graph.states[i];
    for (auto& arc : state.arcs)
      arc.target = part[arc.target];
  }
  return made;
}

} // namespace parlour::adapters::asr
