// Holds the conversations of a suite by voice: each by each voice, several at a
// time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/parlour/conversation_test/test_suite.hpp"
#include "tools/parlour/voice_test/background.hpp"
#include "tools/parlour/voice_test/row_runner.hpp"
#include "tools/parlour/voice_test/word_errors.hpp"

namespace parlour::tools {

// A conversation, held by one voice.
struct VoiceResult {
  std::string file;
  std::string voice;
  std::vector<Row> expected; // by text
  std::vector<Row> found;    // by voice; each row after the right ones
  std::string trouble;       // why it was not held; usually empty
};

struct VoiceWish {
  std::vector<std::string> voices;
  NoiseWish noise;
  bool told = false; // the recogniser knows what is said in the conversations
  unsigned jobs = 0; // threads; 0: one for each core
};

// `typed` is the application without a voice, `spoken` with one (add_voice).
// After a row that went wrong, the conversation begins again and is typed up to
// there, so that each row is measured once and in its place. `voices` has the
// plug-ins that speak for users. An error: a voice cannot speak.
Expected<std::vector<VoiceResult>>
hold_by_voices(const Application& typed, const Application& spoken,
               const TestSuite& suite, const VoiceWish& wish,
               std::shared_ptr<PluginCatalogue> voices);

// What the rows of results have in common.
struct VoiceScore {
  WordErrors words;
  std::size_t rows = 0;
  std::size_t right = 0;          // understood as by text
  std::size_t answered = 0;       // understood and answered as by text
  std::vector<Latency> latencies; // the shortest first
};

// Of the results of one voice.
VoiceScore score_of(const std::vector<VoiceResult>& results,
                    const std::string& voice);
// The time that so many percent of the latencies do not exceed.
Milliseconds percentile(const std::vector<Latency>& sorted, int percent);

} // namespace parlour::tools
