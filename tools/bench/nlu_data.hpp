// Public data sets for understanding, as an application's topics with examples,
// and texts that were not among them.
#pragma once

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
  std::vector<NluText> texts;
};

// CLINC150 of github.com/clinc/oos-eval: data_full.json in this folder, its
// oos-eval/ or data/ below. Slots there are none.
Expected<NluData> read_clinc(const std::filesystem::path& folder);

// SNIPS of github.com/sonos/nlu-benchmark: 2017-06-custom-intent-engines in
// this folder or its nlu-benchmark/.
Expected<NluData> read_snips(const std::filesystem::path& folder);

} // namespace parlour::tools
