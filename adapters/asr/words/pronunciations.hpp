// How words sound: from the recogniser's dictionary, and for those that it
// lacks from espeak-ng.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::asr {

// Several for one word; each is phones with blanks between: "HH AH L OW".
// A word without any is missing: an empty list does not occur.
using Pronunciations = std::map<std::string, std::vector<std::string>>;

// Those of these words that a dictionary in the format of PocketSphinx has: a
// word a line, then its phones; "word(2)" for another way to say it.
Expected<Pronunciations> dictionary_sounds(const std::filesystem::path& file,
                                           const std::set<std::string>& words);

// Those of these words that espeak-ng knows how to say, by running it. Blocks,
// for at most ten seconds. Empty where it is not installed. It runs in a
// process of its own, since the library has one state for all of a process,
// which a voice may be using.
Pronunciations espeak_sounds(const std::set<std::string>& words);

// What an application says of its words (<pronounce>), by the words as they are
// said: "Ho" is "ho".
Pronunciations given_sounds(const std::vector<PronunciationModel>& given);

// The sounds of these words: those that are given, else by the dictionary in
// the folder of a model of PocketSphinx, else by espeak_sounds(). Words without
// any are left out. An error of kind Settings if there is no dictionary.
Expected<Pronunciations> model_sounds(const std::filesystem::path& model,
                                      const std::set<std::string>& words,
                                      const Pronunciations& given = {});

// As PocketSphinx reads it.
std::string dictionary_text(const Pronunciations& sounds);

} // namespace parlour::adapters::asr
