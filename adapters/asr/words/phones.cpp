#include "adapters/asr/words/phones.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "runtime/text/phones.hpp"

namespace parlour::adapters::asr {

namespace {

using Entry = std::pair<std::string_view, std::string_view>;

// espeak-ng's names of phonemes, American English, and the model's phones.
constexpr Entry table[] = {
    // vowels
    {"i:", "IY"},
    {"i", "IY"},
    {"I", "IH"},
    {"I2", "IH"},
    {"I#", "IH"},
    {"E", "EH"},
    {"E2", "EH"},
    {"E#", "IH"},
    {"e", "EH"},
    {"a", "AE"},
    {"a2", "AE"},
    {"aa", "AE"},
    {"a#", "AH"},
    {"A:", "AA"},
    {"A", "AA"},
    {"A~", "AA N"},
    {"0", "AA"},
    {"0#", "AA"},
    {"O:", "AO"},
    {"O", "AO"},
    {"O2", "AO"},
    {"O~", "AO N"},
    {"o", "OW"},
    {"oU", "OW"},
    {"oU#", "OW"},
    {"o:", "OW"},
    {"u:", "UW"},
    {"u", "UW"},
    {"U", "UH"},
    {"V", "AH"},
    {"@", "AH"},
    {"@2", "AH"},
    {"@5", "AH"},
    {"3:", "ER"},
    {"3", "ER"},
    {"3r", "ER"},
    {"@r", "ER"},
    // diphthongs and r-coloured vowels
    {"eI", "EY"},
    {"aI", "AY"},
    {"aU", "AW"},
    {"OI", "OY"},
    {"aI@", "AY AH"},
    {"aI3", "AY ER"},
    {"aU@", "AW AH"},
    {"aU3", "AW ER"},
    {"i@", "IY AH"},
    {"i@3", "IH R"},
    {"I@", "IH R"},
    {"e@", "EH R"},
    {"E@", "EH R"},
    {"A@", "AA R"},
    {"A@r", "AA R"},
    {"O@", "AO R"},
    {"o@", "AO R"},
    {"U@", "UH R"},
    {"u@", "UW AH"},
    {"e:", "EY"},
    {"W", "W"},
    {"y", "UW"},
    {"y:", "UW"},
    {"Y", "ER"},
    {"Y:", "ER"},
    // consonants
    {"p", "P"},
    {"b", "B"},
    {"t", "T"},
    {"t#", "T"},
    {"t2", "T"},
    {"d", "D"},
    {"k", "K"},
    {"g", "G"},
    {"f", "F"},
    {"v", "V"},
    {"T", "TH"},
    {"D", "DH"},
    {"s", "S"},
    {"z", "Z"},
    {"z#", "Z"},
    {"S", "SH"},
    {"Z", "ZH"},
    {"h", "HH"},
    {"x", "K"},
    {"C", "SH"},
    {"tS", "CH"},
    {"dZ", "JH"},
    {"m", "M"},
    {"n", "N"},
    {"N", "NG"},
    {"l", "L"},
    {"r", "R"},
    {"R", "R"},
    {"w", "W"},
    {"j", "Y"},
    {"ts", "T S"},
    {"dz", "D Z"},
    {"n^", "N Y"},
    {"l^", "L Y"},
    {"Q", "G"},
    // consonants that are syllables; a stop of the breath
    {"@L", "AH L"},
    {"n-", "AH N"},
    {"m-", "AH M"},
    {"r-", "ER"},
    {"?", ""},
    {"*", "T"},
    {";", ""}};

// The parts of a text between blanks and '_'.
// Views into `text`.
std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  constexpr std::string_view between = " _\t\r\n|";
  for (auto at = text.find_first_not_of(between);
       at != std::string_view::npos;) {
    const auto end = std::min(text.find_first_of(between, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(between, end);
  }
  return parts;
}

// Without the signs of stress before it.
std::string_view unstressed(std::string_view phoneme) {
  const auto first = phoneme.find_first_not_of("',%=");
  return first == std::string_view::npos ? "" : phoneme.substr(first);
}

} // namespace

// One unknown phoneme makes the word unknown: a word without a sound would be
// found in others.
std::optional<std::string> phones_of(std::string_view phonemes) {
  std::string made;
  for (const auto part : parts_of(phonemes)) {
    const auto phoneme = unstressed(part);
    const auto* const found = std::ranges::find(table, phoneme, &Entry::first);
    if (found == std::end(table)) {
      if (phoneme.empty())
        continue;
      return {};
    }
    if (!found->second.empty())
      made.append(made.empty() ? "" : " ").append(found->second);
  }
  if (made.empty())
    return {};
  return made;
}

bool are_phones(std::string_view text) {
  const auto parts = parts_of(text);
  return !parts.empty() &&
         std::ranges::all_of(parts, [](auto part) { return is_phone(part); });
}

} // namespace parlour::adapters::asr
