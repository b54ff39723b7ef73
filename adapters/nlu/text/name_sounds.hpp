// The sounds of the names of people, and how much of a name is heard in sounds
// that may be divided into other words: "Vijson of Chandran" for Vijay s/o
// Chandran. Words are in lower case.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::nlu {

// The sounds of a whole name, its words one behind the other.
struct NameSounds {
  std::string phones;
  std::uint32_t kinds = 0; // a bit for each of them, as by sounds_in()
};

// As it is said: "s/o" is "son of".
NameSounds sounds_of_name(const std::vector<std::string>& words);

// "bin", "son of", titles: they are misheard most, and tell nobody apart.
bool joins_names(const std::string& word);

// How many words of a name sound unlike what was heard in their place, with
// `heard` divided so that they are as few as can be. Each word must sound as
// much alike as `least`, but for those that join names. `heard` are the phones
// of what was said.
std::size_t words_unlike(std::string_view heard,
                         const std::vector<std::string>& name, double least);

} // namespace parlour::adapters::nlu
