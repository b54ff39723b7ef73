// Measures how much of a public data set an engine understands, as an
// application has it: with generic acts and the usual threshold.
#pragma once

#include <cstddef>
#include <vector>

#include "adapters/nlu/understand/nlu_engine.hpp"
#include "tools/bench/nlu/nearest_example.hpp"
#include "tools/bench/nlu/nlu_data.hpp"

namespace parlour::tools {

// When everything is said.
inline constexpr const char* data_trial_time = "2026-11-21 09:00";

// `part` of `whole` in percent; 0 if there is no whole.
double percent(std::size_t part, std::size_t whole);

// Compares the slots that were found with those that should be.
struct SlotCount {
  std::size_t wanted = 0;
  std::size_t found = 0;
  std::size_t right = 0;

  void add(const NluText& text, const Value& act);
  // The harmonic mean of precision and recall, in percent.
  double f1() const;
};

// Counts over several engines.
struct DataTrial {
  void add(const std::vector<NluText>& texts,
           const adapters::nlu::NluEngine& engine,
           const NearestExample& baseline);

  // Texts about a topic, and how many of them were understood as such, by the
  // engine and by the nearest example.
  std::size_t asked = 0;
  std::size_t right = 0;
  std::size_t nearest = 0;
  // Of those: topic and all slots right, and nothing else said.
  std::size_t frames = 0;
  SlotCount slots;
  // Texts about no topic, and those that were not understood.
  std::size_t strangers = 0;
  std::size_t rejected = 0;
  std::size_t texts = 0;
  double seconds = 0;

private:
  void add(const NluText& text, const adapters::nlu::Understanding& made);
};

} // namespace parlour::tools
