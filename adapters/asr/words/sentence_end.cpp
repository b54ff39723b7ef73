// Walks the graph with all possibilities at once; a place within a value set
// remembers where it goes on behind.
#include <set>
#include <tuple>
#include <utility>

#include "adapters/asr/words/language.hpp"

namespace parlour::adapters::asr {

namespace {

// A state of the sentences, or within a set a state of its graph and the one to
// go on at.
struct Place {
  Symbol set = 0;
  std::uint32_t state = 0;
  std::uint32_t behind = 0;
  bool within = false;

  bool operator<(const Place& other) const {
    return std::tie(within, set, state, behind) <
           std::tie(other.within, other.set, other.state, other.behind);
  }
};

// "coffee shop" may end a sentence and may go on with "on the first floor": all
// places count, and one that may end is enough.
//
//   "call jeffery"    may end in "call @Host.Name", if Jeffery is a whole value
//   "call"            begins a sentence, and cannot end there
//   "banana"          begins none: it is lost
class Walk {
public:
  Walk(const WordGraph& graph, const Symbols& symbols,
       const std::map<Symbol, WordGraph>& sets)
      : graph_(graph), symbols_(symbols), sets_(sets) {
    reach({0, 0, 0, false});
  }

  // All places at which the sentence may be behind this word.
  void step(const std::string& word) {
    const auto before = std::exchange(places_, {});
    for (const auto& place : before)
      for (const auto& arc : state(place).arcs)
        if (!symbols_.is_set(arc.symbol) && symbols_.text(arc.symbol) == word)
          reach({place.set, arc.target, place.behind, place.within});
  }

  bool is_lost() const {
    return places_.empty();
  }
  // A place within a value set is never an end by itself: reach() has added the
  // place behind it, where the value may end.
  bool is_end() const {
    for (const auto& place : places_)
      if (!place.within && graph_.states[place.state].is_final)
        return true;
    return false;
  }

private:
  const WordGraph::State& state(const Place& place) const {
    return place.within ? sets_.at(place.set).states[place.state]
                        : graph_.states[place.state];
  }

  // With the places that need no further word.
  void reach(const Place& place) {
    if (!places_.insert(place).second)
      return;
    const auto& here = state(place);
    if (here.is_final)
      reach(place.within ? Place{0, place.behind, 0, false}
                         : Place{0, 0, 0, false}); // the next sentence
    // Sets within sets are rare; they are not looked into.
    if (!place.within)
      for (const auto& arc : here.arcs)
        if (symbols_.is_set(arc.symbol) && sets_.contains(arc.symbol))
          reach({arc.symbol, 0, arc.target, true});
  }

  const WordGraph& graph_;
  const Symbols& symbols_;
  const std::map<Symbol, WordGraph>& sets_;
  std::set<Place> places_;
};

} // namespace

// Nothing, where no sentence begins like this: whoever asks must not cut in.
std::optional<bool>
Language::ends(const WordGraph& graph,
               const std::vector<std::string>& words) const {
  Walk walk(graph, symbols_, sets_);
  for (const auto& word : words)
    walk.step(word);
  if (walk.is_lost() || words.empty())
    return {};
  return walk.is_end();
}

} // namespace parlour::adapters::asr
