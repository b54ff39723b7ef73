// A file of four word vectors with two numbers each.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/nlu/learning/word_vectors.hpp"
#include "adapters/nlu/text/hash.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::nlu::test {

template <class T>
std::string bytes_of(T number) {
  return {reinterpret_cast<const char*>(&number), sizeof(T)};
}

// As tools/words writes it: taxi and cab are alike, train is like them, bank is
// something else and counts half.
inline std::string small_vectors_file() {
  struct Word {
    std::string_view word;
    float step;
    std::uint16_t group;
    std::uint16_t smaller_group;
    signed char steps[2];
  };
  std::vector<Word> words{{"taxi", 1.0F / 127, 1, 1, {90, 90}},
                          {"cab", 1.0F / 127, 1, 1, {76, 102}},
                          {"train", 1.0F / 127, 1, 2, {38, 121}},
                          {"bank", 0.5F / 127, 2, 3, {102, -76}}};
  std::ranges::sort(words, {},
                    [](const Word& word) { return hash_of(word.word); });
  auto bytes =
      "PARLOURW" + bytes_of<std::uint32_t>(4) + bytes_of<std::uint32_t>(2);
  for (const auto& [word, step, group, smaller_group, steps] : words)
    bytes += bytes_of(hash_of(word)) + bytes_of(step) + bytes_of(group) +
             bytes_of(smaller_group) + bytes_of(steps[0]) + bytes_of(steps[1]);
  return bytes;
}

inline Expected<std::shared_ptr<const WordVectors>>
vectors_of(const std::string& bytes) {
  const parlour::test::TemporaryFolder folder;
  folder.write("words.vectors", bytes);
  return WordVectors::read(folder.path() / "words.vectors");
}

inline std::shared_ptr<const WordVectors> small_vectors() {
  return *vectors_of(small_vectors_file());
}

} // namespace parlour::adapters::nlu::test
