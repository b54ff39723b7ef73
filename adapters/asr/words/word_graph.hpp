// A finite automaton over words: which sentences an application expects. Value
// sets (names, times) are symbols of their own, with a graph each, so that six
// hundred names in twenty rules are kept once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace parlour::adapters::asr {

// The number of a word or of a value set, from 0.
using Symbol = std::uint32_t;

// Numbers words and value sets. Not thread-safe.
// A word and a value set of the same text have different numbers.
class Symbols {
public:
  Symbol word(std::string_view text);
  Symbol value_set(std::string_view name);

  const std::string& text(Symbol symbol) const {
    return texts_[symbol];
  }
  bool is_set(Symbol symbol) const {
    return is_set_[symbol];
  }
  std::size_t size() const {
    return texts_.size();
  }

private:
  Symbol number(std::string_view text, bool is_set);

  std::vector<std::string> texts_;
  std::vector<bool> is_set_;
  std::map<std::pair<bool, std::string>, Symbol> numbers_;
};

// State 0 is the start. What a regular expression over words would be,
// compiled. Paths may be rings, and several arcs of a state may have the same
// symbol: a graph without such choices has five times as many arcs for the
// receptionist.
struct WordGraph {
  struct Arc {
    Symbol symbol = 0;
    std::uint32_t target = 0;

    bool operator==(const Arc&) const = default;
    bool operator<(const Arc& other) const {
      return std::tie(symbol, target) < std::tie(other.symbol, other.target);
    }
  };
  // The arcs are sorted; no two are equal.
  struct State {
    std::vector<Arc> arcs;
    bool is_final = false;
  };
  std::vector<State> states;

  std::size_t arc_count() const;
};

// Collects sentences and makes a graph of them. Moves may be empty and
// ambiguous. Bounded: what exceeds the bound is left out (is_full()).
class GraphBuilder {
public:
  using State = std::uint32_t;

  explicit GraphBuilder(std::size_t most_states = 200'000);

  static constexpr State start = 0;
  // When it is full, the last state: later moves are ignored anyway.
  State add();
  void link(State from, State to);
  void take(State from, State to, Symbol symbol);
  void accept(State state);
  void add_sentence(const std::vector<Symbol>& sentence);

  // Wherever `first` and `second` follow each other, `both` may stand for them:
  // "i'm" for "i am".
  void contract(Symbol first, Symbol second, Symbol both);

  bool is_full() const {
    return is_full_;
  }

  // Without empty moves, and with few states: those from which, or up to which,
  // the same can be said are one. One state that is not final if there is no
  // sentence.
  WordGraph finish() const;

private:
  struct Node {
    std::vector<State> empty;
    std::vector<WordGraph::Arc> arcs;
    bool is_final = false;
  };

  std::vector<State> closure(State state) const;

  std::size_t most_states_;
  std::vector<Node> nodes_;
  bool is_full_ = false;
};

} // namespace parlour::adapters::asr
