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
  // Empty if it is about none. An act about no topic: its name, such as
  // "greet".
  std::string topic;
  // Names and words.
  std::vector<std::pair<std::string, std::string>> slots;
};

struct NluData {
  UnderstandingModel model;
  ColumnReader columns = {};
  // The texts that are measured.
  std::vector<NluText> texts;
};

// Each is learnt and measured by itself; they are counted together.
using NluSets = std::vector<NluData>;

// The part that is measured. Settings are chosen by the validation part, never
// by the test.
enum class DataPart : std::uint8_t { test, validation };

// CLINC150 (github.com/clinc/oos-eval): data_full.json in the folder or in its
// oos-eval/ or data/. It has no slots, and a validation part of its own.
Expected<NluSets> read_clinc(const std::filesystem::path& folder,
                             DataPart part);

// SNIPS (github.com/sonos/nlu-benchmark): 2017-06-custom-intent-engines in the
// folder or in its nlu-benchmark/. For validation every tenth example is held
// out of the training.
Expected<NluSets> read_snips(const std::filesystem::path& folder,
                             DataPart part);

// -- for readers --------------------------------------------------------------

// The first of the places in the folder that exists. The error names the first
// one.
Expected<std::filesystem::path>
first_there(const std::filesystem::path& folder,
            const std::vector<std::string>& places);
// Finds or adds a topic, or a slot that takes any words.
TopicModel& topic_of(NluData& data, const std::string& name);
void add_slot(TopicModel& topic, const std::string& slot);
// Without the characters that have a meaning in an example.
std::string unmarked(std::string text);
// Where a set has no validation part, every tenth example is held out.
inline constexpr std::size_t held_out_of = 10;

} // namespace parlour::tools
