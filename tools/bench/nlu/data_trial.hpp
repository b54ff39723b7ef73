// How well an understander does on texts of a public data set, and how surely.
#pragma once

#include <cstddef>
#include <vector>

#include "adapters/nlu/understand/understander.hpp"
#include "tools/bench/nlu/nlu_data.hpp"

namespace parlour::tools {

double percent(std::size_t part, std::size_t whole);

// How many slots were found as they should be.
struct SlotCount {
  std::size_t wanted = 0;
  std::size_t found = 0;
  std::size_t right = 0;

  void add(const NluText& text, const adapters::nlu::Understanding& made);
  double f1() const; // in percent
};

// Everything is taken for what it is likeliest about: the threshold is none.
class DataTrial {
public:
  DataTrial(const std::vector<NluText>& texts,
            const adapters::nlu::Understander& understander);

  // The score that 95 of 100 texts about a topic reach.
  double limit() const;

  std::size_t asked = 0; // about a topic
  std::size_t right = 0;
  SlotCount slots;
  std::vector<double> scores;    // of texts about a topic, lowest first
  std::vector<double> strangers; // of the others
  double seconds = 0;

private:
  void add(const NluText& text, const adapters::nlu::Understanding& made);
};

double percent_below(const std::vector<double>& scores, double limit);

} // namespace parlour::tools
