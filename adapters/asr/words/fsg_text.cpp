// States are numbered as they come. A state of a value set that is final and
// goes on exists twice for its incoming arcs: as itself and as the end. So no
// empty transition is needed there, of which the decoder would form all
// combinations. Those of sentences are few, and have one: each word that leads
// to the end costs the decoder three kilobytes, as any sentence may follow.
#include "adapters/asr/words/fsg_text.hpp"

#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace parlour::adapters::asr {

namespace {

// States of the sentences come first, then those of the copies of sets.
//
//   FSG_BEGIN parlour
//   NUM_STATES 3
//   START_STATE 0
//   FINAL_STATE 2
//   TRANSITION 0 1 0.5 where
//   FSG_END
class Writer {
public:
  Writer(const Symbols& symbols, const std::map<Symbol, WordGraph>& sets,
         const FsgOptions& options)
      : symbols_(symbols), sets_(sets), options_(options) {}

  // The number of states is known at the end, and stands in the first lines.
  FsgText write(const WordGraph& graph) {
    const auto first = states_;
    states_ += graph.states.size();
    end_ = states_++;
    write_sentences(graph, first);
    leave_shared();
    if (options_.another > 0)
      line(end_, first, options_.another, "");
    FsgText made;
    made.text = fmt::format("FSG_BEGIN parlour\nNUM_STATES {}\nSTART_STATE "
                            "{}\nFINAL_STATE {}\n",
                            states_, first, end_);
    made.text.append(lines_.begin(), lines_.end());
    made.text += "FSG_END\n";
    made.states = states_;
    made.transitions = transitions_;
    made.is_whole = is_whole_;
    return made;
  }

private:
  // All that follow are equally probable.
  static double share(const WordGraph::State& state) {
    return 1.0 / static_cast<double>(state.arcs.size() + state.is_final);
  }

  void line(std::size_t from, std::size_t to, double probability,
            const std::string& word) {
    if (transitions_ >= options_.most_transitions) {
      is_whole_ = false;
      return;
    }
    ++transitions_;
    fmt::format_to(std::back_inserter(lines_), "TRANSITION {} {} {:.6g} {}\n",
                   from, to, probability, word);
  }

  // An arc to a state that only ends leads to the common end at once.
  void write_sentences(const WordGraph& graph, std::size_t first) {
    for (std::size_t i = 0; i < graph.states.size(); ++i) {
      const auto& state = graph.states[i];
      for (const auto& arc : state.arcs) {
        const bool goes_on = !graph.states[arc.target].arcs.empty();
        if (goes_on || graph.states[arc.target].is_final)
          move(first + i, goes_on ? first + arc.target : end_, share(state),
               arc.symbol);
      }
      if (i > 0 && state.is_final && !state.arcs.empty())
        line(first + i, end_, share(state), "");
    }
  }

  // A word is one line; a value set, the way into a copy of its graph.
  void move(std::size_t from, std::size_t to, double probability,
            Symbol symbol) {
    if (!symbols_.is_set(symbol))
      return line(from, to, probability, symbols_.text(symbol));
    const auto set = sets_.find(symbol);
    if (set == sets_.end() || set->second.states[0].arcs.empty())
      return;
    if (set->second.arc_count() > options_.most_copied)
      return move_shared(from, to, probability, symbol, set->second);
    const auto [place, is_new] = places_.try_emplace({symbol, to}, states_);
    if (is_new)
      write_set(set->second, to);
    line(from, place->second, probability, "");
  }

  // Behind the one copy of a large set, all may follow that follows anywhere
  // behind the set.
  void move_shared(std::size_t from, std::size_t to, double probability,
                   Symbol symbol, const WordGraph& set) {
    const auto [found, is_new] = shared_.try_emplace(symbol);
    auto& copy = found->second;
    if (is_new) {
      copy.end = states_++;
      copy.begin = states_;
      write_set(set, copy.end);
    }
    line(from, copy.begin, probability, "");
    copy.behind.insert(to);
  }

  void leave_shared() {
    for (const auto& [symbol, copy] : shared_)
      for (const auto to : copy.behind)
        line(copy.end, to, 1.0 / static_cast<double>(copy.behind.size()), "");
  }

  // A copy of the set's graph that goes on at `to`.
  void write_set(const WordGraph& set, std::size_t to) {
    const auto first = states_;
    states_ += set.states.size();
    for (std::size_t i = 0; i < set.states.size(); ++i)
      for (const auto& arc : set.states[i].arcs) {
        const auto& target = set.states[arc.target];
        const auto probability = share(set.states[i]);
        if (!target.arcs.empty())
          move(first + i, first + arc.target, probability, arc.symbol);
        if (target.is_final)
          move(first + i, to, probability, arc.symbol);
      }
  }

  const Symbols& symbols_;
  const std::map<Symbol, WordGraph>& sets_;
  FsgOptions options_;
  fmt::memory_buffer lines_;
  std::size_t states_ = 0;
  std::size_t transitions_ = 0;
  std::size_t end_ = 0;
  bool is_whole_ = true;
  // Where the copy of a set begins that goes on at a state.
  std::map<std::pair<Symbol, std::size_t>, std::size_t> places_;
  struct Shared {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::set<std::size_t> behind;
  };
  std::map<Symbol, Shared> shared_;
};

} // namespace

FsgText fsg_text(const WordGraph& graph, const Symbols& symbols,
                 const std::map<Symbol, WordGraph>& sets,
                 const FsgOptions& options) {
  return Writer(symbols, sets, options).write(graph);
}

} // namespace parlour::adapters::asr
