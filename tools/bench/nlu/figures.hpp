// What all rows of `parlour bench nlu` print and measure: figures with bars, an
// engine with the time and memory that it took.
#pragma once

#include <string>

#include "adapters/nlu/understand/nlu_engine.hpp"

namespace parlour::tools {

const char* met(bool ok);

// A figure with its bar.
std::string at_least(double figure, double bar, const char* unit = " %");
std::string at_most(double figure, double bar, const char* unit);

struct TrainedEngine {
  adapters::nlu::NluEngine engine;
  double milliseconds = 0;
  double mebibytes = 0;
};

// Memory is measured as the difference before and after, so it includes the
// vocabulary and the automaton.
Expected<TrainedEngine> train(const UnderstandingModel& model,
                              const ColumnReader& columns,
                              adapters::nlu::NluEngine::Options options);

} // namespace parlour::tools
