// KeywordSearch: looks for phrases in one stream of audio that never ends. A
// phrase is found if it is so much more probable than other speech as its
// sounds allow: a short one must be clearer.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "adapters/asr/sphinx/sphinx_decoder.hpp"
#include "adapters/asr/words/pronunciations.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::asr {

// Phrases, how their words sound, and what is enough to find them.
struct Keywords {
  struct Phrase {
    std::string written;
    std::string spoken;     // "hey parlour"
    std::size_t sounds = 0; // how many it has at least
  };
  std::vector<Phrase> phrases;
  std::string dictionary;
  // The least score for each sound.
  double least_score = 0;
};

// `sensitivity` is 0 (nothing but clear speech) to 1. An error of kind Settings
// if a phrase has no words, or if it is unknown how one of them sounds. What
// the application says of that is `given`. Blocks for up to some seconds.
Expected<Keywords> make_keywords(const std::vector<std::string>& phrases,
                                 const std::string& model, double sensitivity,
                                 const Pronunciations& given = {});

struct FoundKeyword {
  std::string phrase;    // as it was written
  double confidence = 0; // 0.5 to 1
};

// For one thread at a time.
// One for each session that listens.
class KeywordSearch {
public:
  static Expected<KeywordSearch> make(std::shared_ptr<const Keywords> keywords,
                                      const std::string& model);

  // Takes the next audio. What is found in it ended in it, or up to 200 ms
  // before.
  std::vector<FoundKeyword> hear(std::span<const Sample> audio);
  // The next audio does not follow.
  void begin();

private:
  KeywordSearch(std::shared_ptr<const Keywords> keywords,
                SphinxDecoder decoder);

  FoundKeyword found(const SpottedPhrase& spotted) const;

  std::shared_ptr<const Keywords> keywords_;
  SphinxDecoder decoder_;
};

} // namespace parlour::adapters::asr
