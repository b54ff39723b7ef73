// The sounds of a word as its spelling suggests, and how alike two words sound.
// Unlike sound_of() it keeps the vowels, and it knows how names of Singapore
// are written: "zhang" and "jang", "xiu" and "shew", "hui" and "hooey".
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace parlour::adapters::nlu {

// One letter for each sound: "xiu" gives "Siu", "quek" gives "kwek". Empty if
// the word has other letters than a to z. The word must be in lower case.
std::string phones_of(std::string_view word);

// 1 for equal sounds, 0 for sounds with nothing in common. Sounds that are
// mistaken for each other (t and d, n and ng, a and e) cost less than others.
// Only the first 32 sounds count. `least` is as in similarity().
double sounds_alike(std::string_view left, std::string_view right,
                    double least = 0);

// A bit for each sound that these have.
std::uint32_t sounds_in(std::string_view phones);

// The most that two words can sound alike, the longer of which has this many
// sounds, by which sounds each of them has.
double sounds_alike_at_most(std::uint32_t left, std::uint32_t right,
                            std::size_t length);

// The kinds of consonants of these sounds, without vowels and without sounds
// that come and go (h, w, y): equal for words that may be written for each
// other. "jang" and "zhang" have "sn", and so has "shin".
std::string outline_of(std::string_view phones);

} // namespace parlour::adapters::nlu
