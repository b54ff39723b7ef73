#include "adapters/asr/words/sentences.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

namespace parlour::adapters::asr {

namespace {

// In words or sets; rings in a grammar would go on for ever.
constexpr std::size_t longest = 40;

// The number of sentences of each state, so that a set of names is drawn from
// evenly, whatever its graph looks like. Loops count as if they were left soon.
// The same seed and graph give the same sentences on every machine, as no
// distribution of the standard library is used.
// `evenly`: all sentences are equally probable, else all ways on at each state.
class Drawing {
public:
  Drawing(const WordGraph& graph, bool evenly, std::uint64_t seed)
      : graph_(graph), random_(seed) {
    if (evenly)
      count_sentences();
  }

  // Empty if none was found.
  Sentence draw() {
    return go_on({}, 0);
  }

  // One sentence through each arc of the graph.
  std::vector<Sentence> draw_all() {
    find_ways();
    std::vector<Sentence> sentences;
    for (std::uint32_t state = 0; state < graph_.states.size(); ++state)
      if (state == 0 || !ways_[state].empty())
        for (const auto& arc : graph_.states[state].arcs) {
          auto sentence = way_to(state);
          sentence.push_back(arc.symbol);
          sentences.push_back(go_on(std::move(sentence), arc.target));
        }
    return sentences;
  }

private:
  // An arc that leads to a state, from one nearer to the start.
  struct Way {
    std::uint32_t from = 0;
    Symbol symbol = 0;
  };

  // Breadth first, so that each way is the shortest.
  void find_ways() {
    constexpr auto unseen = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> depths(graph_.states.size(), unseen);
    std::vector<std::uint32_t> queue{0};
    depths[0] = 0;
    ways_.resize(graph_.states.size());
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const auto& arc : graph_.states[queue[i]].arcs) {
        if (depths[arc.target] == unseen) {
          depths[arc.target] = depths[queue[i]] + 1;
          queue.push_back(arc.target);
        }
        if (depths[arc.target] > depths[queue[i]])
          ways_[arc.target].push_back({queue[i], arc.symbol});
      }
  }

  Sentence way_to(std::uint32_t state) {
    Sentence sentence;
    while (state != 0) {
      const auto& ways = ways_[state];
      const auto& way = ways[random_() % ways.size()];
      sentence.push_back(way.symbol);
      state = way.from;
    }
    std::ranges::reverse(sentence);
    return sentence;
  }

  // A sentence that is still not over at its longest is given up.
  Sentence go_on(Sentence sentence, std::uint32_t at) {
    while (sentence.size() < longest) {
      const auto& state = graph_.states[at];
      const auto chosen = choose(at);
      if (chosen == state.arcs.size())
        return sentence;
      sentence.push_back(state.arcs[chosen].symbol);
      at = state.arcs[chosen].target;
    }
    return graph_.states[at].is_final ? sentence : Sentence();
  }

  double weight(std::uint32_t state) const {
    return counts_.empty() ? 1 : counts_[state];
  }

  // Repeated until nothing changes, at most as often as a sentence has words.
  void count_sentences() {
    std::vector<double> counts(graph_.states.size());
    for (std::size_t length = 0; length < longest; ++length) {
      auto next = counts;
      for (std::size_t i = 0; i < counts.size(); ++i) {
        next[i] = graph_.states[i].is_final;
        for (const auto& arc : graph_.states[i].arcs)
          next[i] += counts[arc.target];
        next[i] = std::min(next[i], 1e12);
      }
      if (std::exchange(counts, next) == counts)
        break;
    }
    counts_ = std::move(counts);
  }

  // The index of an arc; their number for the end.
  std::size_t choose(std::uint32_t at) {
    const auto& state = graph_.states[at];
    double sum = state.is_final;
    for (const auto& arc : state.arcs)
      sum += weight(arc.target);
    auto left = sum * static_cast<double>(random_() >> 11) * 0x1.0p-53;
    for (std::size_t i = 0; i < state.arcs.size(); ++i) {
      left -= weight(state.arcs[i].target);
      if (left < 0)
        return i;
    }
    return state.arcs.size();
  }

  const WordGraph& graph_;
  std::mt19937_64 random_;
  std::vector<double> counts_;
  std::vector<std::vector<Way>> ways_;
};

} // namespace

std::vector<Sentence> draw_sentences(const WordGraph& graph, std::size_t count,
                                     std::uint64_t seed) {
  std::vector<Sentence> sentences;
  Drawing drawing(graph, false, seed);
  for (std::size_t i = 0; i < count; ++i)
    if (auto sentence = drawing.draw(); !sentence.empty())
      sentences.push_back(std::move(sentence));
  return sentences;
}

std::vector<Sentence> cover_arcs(const WordGraph& graph, std::uint64_t seed) {
  auto sentences = Drawing(graph, false, seed).draw_all();
  std::erase_if(sentences,
                [](const auto& sentence) { return sentence.empty(); });
  return sentences;
}

// Each set draws with a seed of its own: more values in one do not change what
// is drawn from another.
std::vector<Sentence> fill_sets(const std::vector<Sentence>& sentences,
                                const Symbols& symbols,
                                const std::map<Symbol, WordGraph>& sets,
                                std::uint64_t seed) {
  std::map<Symbol, Drawing> drawings;
  for (const auto& [set, graph] : sets)
    drawings.try_emplace(set, graph, true, seed + set);
  std::vector<Sentence> filled;
  for (const auto& sentence : sentences) {
    Sentence made;
    bool is_whole = true;
    for (const auto symbol : sentence) {
      if (!symbols.is_set(symbol)) {
        made.push_back(symbol);
        continue;
      }
      const auto found = drawings.find(symbol);
      const auto value =
          found == drawings.end() ? Sentence() : found->second.draw();
      is_whole &= !value.empty();
      made.insert(made.end(), value.begin(), value.end());
    }
    if (is_whole)
      filled.push_back(std::move(made));
  }
  return filled;
}

} // namespace parlour::adapters::asr
