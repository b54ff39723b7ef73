// Groups of letters that are read as one, found by their first letter: most
// letters of a word begin none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace parlour::adapters::nlu {

inline constexpr std::size_t letter_count = 26;

// Some of the letters a to z.
class LetterSet {
public:
  constexpr explicit LetterSet(std::string_view letters) {
    for (const char letter : letters)
      bits_ |= std::uint32_t{1} << (letter - 'a');
  }
  constexpr bool contains(char letter) const {
    const auto place = static_cast<std::size_t>(letter - 'a');
    return place < letter_count && (bits_ >> place & 1U) != 0;
  }

private:
  std::uint32_t bits_ = 0;
};

struct LetterGroup {
  std::string_view letters; // from a to z
  std::string_view sounds;
};

template <std::size_t size>
class LetterGroups {
public:
  constexpr explicit LetterGroups(const std::array<LetterGroup, size>& all) {
    std::size_t made = 0;
    for (std::size_t letter = 0; letter < letter_count; ++letter) {
      for (const auto& one : all)
        if (one.letters.front() == static_cast<char>('a' + letter))
          all_[made++] = one;
      ends_[letter + 1] = made;
    }
  }

  // With which of them the text begins; of several, the first of the table.
  // Null: none.
  constexpr const LetterGroup* find(std::string_view text) const {
    if (text.empty())
      return nullptr;
    const auto letter = static_cast<std::size_t>(text.front() - 'a');
    if (letter < letter_count)
      for (auto at = ends_[letter]; at < ends_[letter + 1]; ++at)
        if (text.starts_with(all_[at].letters))
          return &all_[at];
    return nullptr;
  }

private:
  std::array<LetterGroup, size> all_{}; // by first letter
  std::array<std::size_t, letter_count + 1> ends_{};
};

} // namespace parlour::adapters::nlu
