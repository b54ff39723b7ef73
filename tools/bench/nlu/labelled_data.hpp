// Reads more public data sets (nlu_data): files of texts, of their labels, and
// of the slots of their words.
#pragma once

#include "tools/bench/nlu/nlu_data.hpp"

namespace parlour::tools {

// BANKING77 (github.com/PolyAI-LDN/task-specific-datasets).
Expected<NluSets> read_banking(const std::filesystem::path& folder,
                               DataPart part);

// From github.com/jianguoz/Few-Shot-Intent-Detection: HWU64; ATIS with its
// slots; BANKING77 and CLINC150 with ten examples of each topic.
Expected<NluSets> read_hwu(const std::filesystem::path& folder, DataPart part);
Expected<NluSets> read_atis(const std::filesystem::path& folder, DataPart part);
Expected<NluSets> read_ten_of_banking(const std::filesystem::path& folder,
                                      DataPart part);
Expected<NluSets> read_ten_of_clinc(const std::filesystem::path& folder,
                                    DataPart part);

// Chatbot, AskUbuntu and WebApplications
// (github.com/sebischair/NLU-Evaluation-Corpora), 30 to 100 examples each.
// What they mark as "None" is about no topic, and is not learnt.
Expected<NluSets> read_corpora(const std::filesystem::path& folder,
                               DataPart part);

// The MIT corpora of questions about restaurants and films, as
// github.com/zjunlp/DeepKE has them: slots of one topic, learnt from the
// examples in which each slot occurs up to 500 times, about a quarter of
// all.
Expected<NluSets> read_restaurants(const std::filesystem::path& folder,
                                   DataPart part);
Expected<NluSets> read_films(const std::filesystem::path& folder,
                             DataPart part);

} // namespace parlour::tools
