// Measures how much of a public data set an engine understands, and how certain
// it is.
#pragma once

#include <cstddef>
#include <vector>

#include "adapters/nlu/understand/nlu_engine.hpp"
#include "tools/bench/nlu/nlu_data.hpp"

namespace parlour::tools {

// `part` of `whole` in percent; 0 if there is no whole.
double percent(std::size_t part, std::size_t whole);

// Compares the slots that were found with those that should be.
struct SlotCount {
  std::size_t wanted = 0;
  std::size_t found = 0;
  std::size_t right = 0;

  void add(const NluText& text, const adapters::nlu::Understanding& made);
  // The harmonic mean of precision and recall, in percent.
  double f1() const;
};

// Runs all texts through the engine, whose threshold must be 0: every text is
// assigned to the most likely topic, and the scores are kept.
class DataTrial {
public:
  DataTrial(const std::vector<NluText>& texts,
            const adapters::nlu::NluEngine& engine);

  // The score that 95 of 100 texts about a topic reach.
  double limit() const;

  // Texts about a topic, and how many of them were assigned to the right one.
  std::size_t asked = 0;
  std::size_t right = 0;
  SlotCount slots;
  // Of texts about a topic, lowest first.
  std::vector<double> scores;
  // Of texts about no topic.
  std::vector<double> strangers;
  double seconds = 0;

private:
  void add(const NluText& text, const adapters::nlu::Understanding& made);
};

// How many of the scores are below the limit, in percent.
double percent_below(const std::vector<double>& scores, double limit);

} // namespace parlour::tools
