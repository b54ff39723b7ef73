#include "adapters/asr/words/sentences.hpp"

#include <random>
#include <utility>

namespace parlour::adapters::asr {

namespace {

constexpr std::size_t longest = 40;

// The number of sentences of each state, so that a set of names is drawn from
// evenly, whatever its graph looks like. Loops count as if they were left soon.
class Drawing {
public:
  Drawing(const WordGraph& graph, bool evenly, std::uint64_t seed)
      : graph_(graph), random_(seed) {
    if (evenly)
      count_sentences();
  }

  // Empty if none was found.
  Sentence draw() {
    Sentence sentence;
    std::uint32_t at = 0;
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

private:
  double weight(std::uint32_t state) const {
    return counts_.empty() ? 1 : counts_[state];
  }

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
