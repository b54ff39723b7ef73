// The sounds of words in the phones of PocketSphinx' English model (CMU: AA,
// AE, …), from the phonemes of espeak-ng, for words that its dictionary lacks.
// Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace parlour::adapters::asr {

// "dZ_'E_f_3_r_i" gives "JH EH F ER R IY". Phonemes are separated by '_' or
// blanks; stress and length are ignored. Nothing if a phoneme is unknown or
// there is none.
std::optional<std::string> phones_of(std::string_view phonemes);

// Whether every part is a phone of the model.
bool are_phones(std::string_view phones);

} // namespace parlour::adapters::asr
