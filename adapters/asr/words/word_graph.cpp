// States are merged by refinement of a partition, forwards and backwards.
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

// Tells states apart by which parts their arcs lead to, until nothing changes.
// Only parts are looked at from which arcs lead to what has changed, and of a
// part that falls apart the largest piece keeps its number: in the graphs of
// grammars, most states are looked at few times.
class Refinement {
public:
  Refinement(Parts parts, const std::vector<Arcs>& arcs,
             const std::vector<Arcs>& arcs_to)
      : parts_(std::move(parts)), arcs_(arcs), arcs_to_(arcs_to) {
    members_.resize(std::ranges::max(parts_) + 1);
    for (std::uint32_t state = 0; state < parts_.size(); ++state)
      members_[parts_[state]].push_back(state);
    for (std::uint32_t part = 0; part < members_.size(); ++part)
      touch(part);
  }

  Parts run() {
    while (!touched_.empty()) {
      const auto part = touched_.back();
      touched_.pop_back();
      is_touched_[part] = false;
      split(part);
    }
    return numbered();
  }

private:
  using States = std::vector<std::uint32_t>;

  // One that has a single state cannot fall apart.
  void touch(std::uint32_t part) {
    is_touched_.resize(members_.size());
    if (members_[part].size() < 2 || is_touched_[part])
      return;
    is_touched_[part] = true;
    touched_.push_back(part);
  }

  Arcs signature(std::uint32_t state) const {
    auto signature = arcs_[state];
    for (auto& arc : signature)
      arc.target = parts_[arc.target];
    sort_arcs(signature);
    return signature;
  }

  void split(std::uint32_t part) {
    std::map<Arcs, States> pieces;
    for (const auto state : members_[part])
      pieces[signature(state)].push_back(state);
    if (pieces.size() == 1)
      return;
    const auto size = [](const auto& piece) { return piece.second.size(); };
    const auto largest = std::ranges::max_element(pieces, {}, size);
    members_[part] = std::move(largest->second);
    pieces.erase(largest);
    States moved;
    for (auto& [arcs, states] : pieces) {
      for (const auto state : states)
        parts_[state] = static_cast<std::uint32_t>(members_.size());
      moved.insert(moved.end(), states.begin(), states.end());
      members_.push_back(std::move(states));
    }
    for (const auto state : moved)
      for (const auto& arc : arcs_to_[state])
        touch(parts_[arc.target]);
  }

  // In the order of the states, so that state 0 stays the first.
  Parts numbered() const {
    constexpr auto none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> numbers(members_.size(), none);
    std::uint32_t count = 0;
    Parts made;
    for (const auto part : parts_) {
      if (numbers[part] == none)
        numbers[part] = count++;
      made.push_back(numbers[part]);
    }
    return made;
  }

  Parts parts_;
  const std::vector<Arcs>& arcs_;
  const std::vector<Arcs>& arcs_to_; // the same ones, seen from their ends
  std::vector<States> members_;      // of each part
  std::vector<bool> is_touched_;
  States touched_; // parts
};

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
      merged(living, Refinement(std::move(first_or_not), reversed(living),
                                arcs_of(living))
                         .run());
  Parts final_or_not;
  for (const auto& state : same_begins.states)
    final_or_not.push_back(state.is_final);
  return merged(same_begins,
                Refinement(std::move(final_or_not), arcs_of(same_begins),
                           reversed(same_begins))
                    .run());
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
