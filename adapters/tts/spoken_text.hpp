// A text on its way to a voice: its words, and the pieces in which a
// synthesizer gets them. No character of a text means anything but what it
// says: control characters, by which engines take orders, never reach them.
//
// Pure functions; safe from any thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::tts {

using Words = std::vector<std::string>;

// The parts between blanks, in valid UTF-8. Control characters and bytes that
// are not UTF-8 count as blanks. A word of more than 80 characters comes in
// parts, so that every word has a bound.
Words speakable_words(std::string_view text);

// The number of code points; `text` is valid UTF-8.
std::size_t count_characters(std::string_view text);

// How long pieces are, in bytes with the blanks.
struct PieceLength {
  // A piece of at least this length ends with its sentence.
  std::size_t wanted = 0;
  // It ends here at the latest, after a comma if there is one.
  std::size_t longest = 0;
};

// Cuts the words into pieces, none of them empty.
std::vector<Words> pieces_of(const Words& words, const PieceLength& length);

// The words with a blank between them.
std::string joined(const Words& words);

} // namespace parlour::adapters::tts
