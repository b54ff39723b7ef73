// Hearing: two decoders over the same utterance, one by the grammar and one by
// the domain model. Where they agree, what they heard is right: that is the
// confidence, which neither of them has by itself.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "adapters/asr/sphinx/noise_gate.hpp"
#include "adapters/asr/sphinx/sphinx_decoder.hpp"
#include "adapters/asr/words/language_store.hpp"
#include "adapters/audio/pcm.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::asr {

struct Heard {
  std::vector<HeardWord> words; // of the better text
  std::vector<bool> agreed;     // for each of them, whether both heard it
  double agreement = 0;         // 0 to 1
  std::string by_grammar;
  std::string by_domain;
};

// The text of words, with blanks between.
std::string text_of(const std::vector<std::string>& words);

std::vector<std::string> split_text(const std::string& text);

// What recognisers load: made once, shared by all.
// The texts are read by each decoder when it is made.
struct Vocabulary {
  std::shared_ptr<const MadeLanguage> made;
  std::string domain_model; // ARPA
  std::string dictionary;
  std::string grammar;  // FSG
  bool is_whole = true; // the grammar: else it has more than can be heard
};

// Makes it, with the sounds that the dictionary of the model has, and those of
// espeak-ng. Blocks for up to some seconds.
Expected<Vocabulary> make_vocabulary(const LanguageSources& sources,
                                     const std::string& model);

// One utterance at a time; for one thread at a time.
// Expensive: it has two decoders (README.md). RecogniserPool keeps and lends
// it.
//
//   audio -> NoiseGate -> decoder by the grammar      -> text, word by word
//                      -> decoder by the domain model -> text at the end
//   both texts -> agreement() -> confidence
class Hearing {
public:
  static Expected<Hearing> make(std::shared_ptr<const Vocabulary> vocabulary,
                                const std::string& model);

  // Begins an utterance of these grammars; all if none is named or known.
  Expected<void> begin(const std::vector<std::string>& grammars);
  // Decodes at once, on the caller's thread.
  void hear(std::span<const Sample> audio);
  // What was heard so far, and whether a sentence may end there.
  std::string partial() const;
  std::optional<bool> ends(const std::string& partial) const;
  // Ends the utterance; the next begin() may follow.
  Heard finish();
  void drop();

  const std::shared_ptr<const Vocabulary>& vocabulary() const {
    return vocabulary_;
  }

private:
  // One set of grammars that was asked for, with its search in the decoder.
  struct Narrow {
    std::vector<std::string> names;
    std::string search;
    WordGraph graph;
  };

  Hearing(std::shared_ptr<const Vocabulary> vocabulary, SphinxDecoder grammar,
          SphinxDecoder domain);

  // The search for these grammars; adds it if it is new.
  std::string search_for(const std::vector<std::string>& names);
  const WordGraph& graph() const;

  void decode(std::span<const Sample> audio);

  std::shared_ptr<const Vocabulary> vocabulary_;
  NoiseGate gate_;
  SphinxDecoder grammar_;
  SphinxDecoder domain_;
  std::vector<Narrow> narrow_; // a few
  std::string search_;
};

} // namespace parlour::adapters::asr
