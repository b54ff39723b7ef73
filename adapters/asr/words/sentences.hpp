// Sentences drawn from word graphs at random, for counting: what a domain's
// people may say, in the proportions of its grammars.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "adapters/asr/words/word_graph.hpp"

namespace parlour::adapters::asr {

using Sentence = std::vector<Symbol>;

// Draws `count` sentences in which value sets stand for themselves. The same
// seed gives the same sentences. None from an empty graph; sentences end after
// at most 40 symbols.
// At each state all ways on are equally probable, and so is the end.
std::vector<Sentence> draw_sentences(const WordGraph& graph, std::size_t count,
                                     std::uint64_t seed);

// One through each arc of the graph, so that nothing is forgotten.
std::vector<Sentence> cover_arcs(const WordGraph& graph, std::uint64_t seed);

// Puts a value for each set, all values equally often. Sentences with a set
// that has no values are left out.
std::vector<Sentence> fill_sets(const std::vector<Sentence>& sentences,
                                const Symbols& symbols,
                                const std::map<Symbol, WordGraph>& sets,
                                std::uint64_t seed);

} // namespace parlour::adapters::asr
