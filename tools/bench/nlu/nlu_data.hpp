// Reads public data sets for language understanding as topics with examples,
// and texts that are not among the examples.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "runtime/message/understanding.hpp"

namespace parlour::tools {

struct NluText {
  std::string text;
  // Empty if it is about none.
  std::string topic;
  // Names and words.
  std::vector<std::pair<std::string, std::string>> slots;
};

struct NluData {
  UnderstandingModel model;
  // The texts that are measured.
  std::vector<NluText> texts;
  // The texts by which a threshold is chosen.
  std::vector<NluText> held_out;
};

// The part that is measured. Settings are chosen by the validation part, never
// by the test.
enum class DataPart : std::uint8_t { test, validation };

// CLINC150 (github.com/clinc/oos-eval): data_full.json in the folder or in its
// oos-eval/ or data/. It has no slots, and a validation part of its own.
Expected<NluData> read_clinc(const std::filesystem::path& folder,
                             DataPart part);

// SNIPS (github.com/sonos/nlu-benchmark): 2017-06-custom-intent-engines in the
// folder or in its nlu-benchmark/. For validation every tenth example is held
// out of the training.
Expected<NluData> read_snips(const std::filesystem::path& folder,
                             DataPart part);

} // namespace parlour::tools
