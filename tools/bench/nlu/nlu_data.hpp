// Public data sets for understanding, as an application's topics with examples,
// and texts that were not among them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/understanding.hpp"

namespace parlour::tools {

struct NluText {
  std::string text;
  std::string topic; // "" where it is about none
  std::vector<std::pair<std::string, std::string>> slots; // name, words
};

struct NluData {
  UnderstandingModel model;
  std::vector<NluText> texts;    // that are measured
  std::vector<NluText> held_out; // to choose a threshold by
};

// What is measured: settings are chosen by what training was held back from,
// never by the test.
enum class DataPart : std::uint8_t { test, validation };

// CLINC150 of github.com/clinc/oos-eval: data_full.json in this folder, its
// oos-eval/ or data/ below. Slots there are none. It has a part for validation,
// by which the threshold is chosen too.
Expected<NluData> read_clinc(const std::filesystem::path& folder,
                             DataPart part);

// SNIPS of github.com/sonos/nlu-benchmark: 2017-06-custom-intent-engines in
// this folder or its nlu-benchmark/. For validation every tenth example is held
// out of training.
Expected<NluData> read_snips(const std::filesystem::path& folder,
                             DataPart part);

} // namespace parlour::tools
