// `parlour bench speech`: what becomes of what is said to the receptionist by
// synthetic voices, in noise, and by recordings of people. Its rows:
//
//  load       memory, start and CPU time of the recogniser
//  detector   when speech begins; merged turns
//  foreign    sentences that belong, and those that do not
//  names      600 names of its database
//  digits     numbers of eight digits by real people
//  clean, babble-20, babble-10   all its conversations
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

struct SpeechBenchOptions {
  std::string only; // one row; empty: all
  // A plug-in of the role ASR; empty: the one that a run takes.
  std::string recogniser;
  std::vector<std::string> voices = {"rms", "slt"};
  // The recogniser knows what is said in dialogues/, as in a run.
  bool told = false;
  // The folder of recordings; empty: they are not measured.
  std::filesystem::path data;
  std::vector<std::string> speakers = {"jackson", "nicolas"};
  // Of names and conversations one in so many is tried.
  std::size_t one_in = 1;
  // Prints what was heard.
  bool trace = false;
};

// The names of the rows.
std::vector<std::string> speech_bench_rows();

// Prints the table. False if something could not be measured.
bool speech_bench(const Places& places, const SpeechBenchOptions& options,
                  const Console& console);

} // namespace parlour::tools
