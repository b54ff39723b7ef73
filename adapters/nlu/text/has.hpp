// Whether something is in a short list, where each element is looked at, or a
// digit in a word, or one letter alone.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace parlour::adapters::nlu {

template <class All, class One>
bool has(const All& all, const One& one) {
  return std::ranges::find(all, one) != all.end();
}

inline bool is_one_of(std::string_view word,
                      std::initializer_list<std::string_view> words) {
  return has(words, word);
}

inline bool has_digit(std::string_view word) {
  return std::ranges::any_of(
      word, [](char letter) { return letter >= '0' && letter <= '9'; });
}

inline bool is_letter(std::string_view word) {
  return word.size() == 1 && !has_digit(word);
}

} // namespace parlour::adapters::nlu
