#include "adapters/nlu/encoder/nearest_sentences.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace parlour::adapters::nlu {

void NearestSentences::add(std::vector<float> sentence, std::uint32_t label) {
  all_.push_back({std::move(sentence), label});
}

std::vector<float> NearestSentences::find(const std::vector<float>& sentence,
                                          std::size_t labels) const {
  std::vector<float> made(labels);
  for (const auto& [other, label] : all_)
    if (label < labels && other.size() == sentence.size())
      made[label] =
          std::max(made[label], std::inner_product(other.begin(), other.end(),
                                                   sentence.begin(), 0.0F));
  return made;
}

} // namespace parlour::adapters::nlu
