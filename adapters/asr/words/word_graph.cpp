// States are merged by refinement of a partition (Moore), forwards and
// backwards.
#include "adapters/asr/words/word_graph.hpp"

#include <algorithm>
#include <limits>
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
        for (const auto behind : closure(arc.target))
          for (const auto& next : nodes_[behind].arcs)
            if (next.symbol == second)
              ends.push_back(next.target);
    for (const auto end : ends)
      node.arcs.push_back({both, end});
  }
}

// The states that empty moves lead to, and the state itself.
std::vector<GraphBuilder::State> GraphBuilder::closure(State state) const {
  std::vector<State> states{state};
  for (std::size_t at = 0; at < states.size(); ++at)
    for (const auto next : nodes_[states[at]].empty)
      if (std::ranges::find(states, next) == states.end())
        states.push_back(next);
  return states;
}

namespace {

using Arcs = std::vector<WordGraph::Arc>;
// The number of the part that each state belongs to; state 0 is in part 0.
using Parts = std::vector<std::uint32_t>;

// Of an arc that takes no word.
constexpr Symbol nothing = std::numeric_limits<Symbol>::max();
// A state, on average.
constexpr std::size_t most_arcs = 10;

void sort_arcs(Arcs& arcs) {
  std::sort(arcs.begin(), arcs.end());
  arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());
}

// The arcs that lead to each state, with where they come from.
std::vector<Arcs> reversed(const WordGraph& graph) {
  std::vector<Arcs> made(graph.states.size());
  for (std::uint32_t i = 0; i < graph.states.size(); ++i)
    for (const auto& arc : graph.states[i].arcs)
      made[arc.target].push_back({arc.symbol, i});
  return made;
}

std::vector<Arcs> arcs_of(const WordGraph& graph) {
  std::vector<Arcs> made;
  for (const auto& state : graph.states)
    made.push_back(state.arcs);
  return made;
}

// Which states can be reached from these.
std::vector<bool> reached(const std::vector<Arcs>& arcs,
                          std::vector<std::uint32_t> from) {
  std::vector<bool> is_reached(arcs.size());
  for (const auto state : from)
    is_reached[state] = true;
  for (std::size_t at = 0; at < from.size(); ++at)
    for (const auto& arc : arcs[from[at]])
      if (!is_reached[arc.target]) {
        is_reached[arc.target] = true;
        from.push_back(arc.target);
      }
  return is_reached;
}

// Leaves out what no sentence goes through; the first state stays.
WordGraph without_dead_ends(const WordGraph& graph) {
  std::vector<std::uint32_t> ends;
  for (std::uint32_t i = 0; i < graph.states.size(); ++i)
    if (graph.states[i].is_final)
      ends.push_back(i);
  const auto begun = reached(arcs_of(graph), {0});
  const auto ended = reached(reversed(graph), std::move(ends));
  const auto lives = [&](std::size_t state) {
    return state == 0 || (begun[state] && ended[state]);
  };
  std::vector<std::uint32_t> numbers(graph.states.size());
  WordGraph made;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (lives(i)) {
      numbers[i] = static_cast<std::uint32_t>(made.states.size());
      made.states.push_back(graph.states[i]);
    }
  for (auto& state : made.states) {
    std::erase_if(state.arcs,
                  [&](const auto& arc) { return !lives(arc.target); });
    for (auto& arc : state.arcs)
      arc.target = numbers[arc.target];
  }
  return made;
}

// States are told apart step by step, by which parts their arcs lead to, until
// nothing changes.
Parts refined(Parts parts, const std::vector<Arcs>& arcs) {
  using Signature = std::pair<std::uint32_t, Arcs>;
  for (std::size_t count = 0;;) {
    std::map<Signature, std::uint32_t> numbers;
    Parts next;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      Signature signature{parts[i], arcs[i]};
      for (auto& arc : signature.second)
        arc.target = parts[arc.target];
      sort_arcs(signature.second);
      // Numbered in the order of the states, so that state 0 stays the first.
      next.push_back(
          numbers
              .try_emplace(std::move(signature),
                           static_cast<std::uint32_t>(numbers.size()))
              .first->second);
    }
    parts = std::move(next);
    if (numbers.size() == count)
      return parts;
    count = numbers.size();
  }
}

// Each part becomes one state.
WordGraph merged(const WordGraph& graph, const Parts& parts) {
  WordGraph made;
  made.states.resize(std::ranges::max(parts) + 1);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto& state = made.states[parts[i]];
    state.is_final |= graph.states[i].is_final;
    for (const auto& arc : graph.states[i].arcs)
      state.arcs.push_back({arc.symbol, parts[arc.target]});
  }
  for (auto& state : made.states)
    sort_arcs(state.arcs);
  return made;
}

// States up to which the same was said become one, then those from which the
// same can be said. The sentences stay the same.
WordGraph smaller(const WordGraph& graph) {
  const auto living = without_dead_ends(graph);
  Parts first_or_not(living.states.size(), 1);
  first_or_not[0] = 0;
  const auto same_begins =
      merged(living, refined(std::move(first_or_not), reversed(living)));
  Parts final_or_not;
  for (const auto& state : same_begins.states)
    final_or_not.push_back(state.is_final);
  return merged(same_begins,
                refined(std::move(final_or_not), arcs_of(same_begins)));
}

// A state has the arcs of all to which arcs without a word lead. At most so
// many arcs are made.
WordGraph without_empty(const WordGraph& graph, std::size_t most) {
  WordGraph made;
  std::size_t count = 0;
  const auto size = graph.states.size();
  std::vector<std::size_t> seen_by(size, size);
  for (std::size_t i = 0; i < size; ++i) {
    auto& state = made.states.emplace_back();
    std::vector<std::size_t> closed{i};
    seen_by[i] = i;
    for (std::size_t at = 0; at < closed.size() && count < most; ++at) {
      state.is_final |= graph.states[closed[at]].is_final;
      for (const auto& arc : graph.states[closed[at]].arcs)
        if (arc.symbol != nothing) {
          state.arcs.push_back(arc);
          ++count;
        } else if (std::exchange(seen_by[arc.target], i) != i) {
          closed.push_back(arc.target);
        }
    }
    sort_arcs(state.arcs);
  }
  return made;
}

} // namespace

// Made smaller first, as each empty move may double arcs.
WordGraph GraphBuilder::finish() const {
  WordGraph graph;
  for (const auto& node : nodes_) {
    auto& state = graph.states.emplace_back();
    state.is_final = node.is_final;
    state.arcs = node.arcs;
    for (const auto target : node.empty)
      state.arcs.push_back({nothing, target});
  }
  return smaller(without_empty(smaller(graph), most_arcs * most_states_));
}

} // namespace parlour::adapters::asr
