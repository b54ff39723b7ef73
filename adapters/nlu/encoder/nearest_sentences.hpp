// NearestSentences tells how like a sentence is to the most similar one of each
// label, by what the encoder made of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace parlour::adapters::nlu {

// Once all are added, any number of threads may use it.
class NearestSentences {
public:
  // `sentence` is a vector of length 1, as long as all others.
  void add(std::vector<float> sentence, std::uint32_t label);

  // By label, up to `labels`: 1 for the same sentence, 0 for one that has
  // nothing in common, or none.
  std::vector<float> find(const std::vector<float>& sentence,
                          std::size_t labels) const;

private:
  struct Labelled {
    std::vector<float> sentence;
    std::uint32_t label = 0;
  };

  std::vector<Labelled> all_;
};

} // namespace parlour::adapters::nlu
