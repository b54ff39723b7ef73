// Masking of private data: what is marked private="true" is shown to observers
// as *** (engine rule 7.6).
//
//   Secrets secrets;
//   secrets.add("91234567");
//   secrets.masked("my number is 9123 4567");   // "my number is ***"
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/message/message.hpp"

namespace parlour {

inline constexpr std::string_view mask = "***";

// The texts of a session that must not be shown. Masking takes time in
// proportion to the text's length times the number of secrets. Not thread-safe.
class Secrets {
public:
  // Adds a text, without blanks at its ends. Returns false if nothing is left
  // of it or if it is known already.
  bool add(std::string text);
  void add(const Secrets& others);
  bool empty() const {
    return texts_.empty();
  }

  // Replaces each occurrence of a secret by ***. Upper and lower case are the
  // same, and digits are also found in groups ("9123 4567"). A secret shorter
  // than four bytes is replaced only where it stands alone as a word, since it
  // would otherwise hide parts of unrelated words.
  std::string masked(std::string_view text) const;
  // The same for each text and number in the value.
  Value masked_value(const Value& value) const;
  Message masked_message(Message message) const;

private:
  std::size_t found_at(std::string_view text, std::size_t at) const;

  std::vector<std::string> texts_; // longer ones first
};

// Replaces every text and number in the value.
Value all_masked(const Value& value);

} // namespace parlour
