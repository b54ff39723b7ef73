// SphinxDecoder hears one utterance at a time, by PocketSphinx: by a grammar or
// by a domain model, whichever is chosen. For one thread at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "adapters/audio/pcm.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::asr {

struct HeardWord {
  std::string word;
  std::int64_t begin = 0; // ms since the utterance began
  std::int64_t end = 0;
};

// A phrase that a search for keywords has found.
struct SpottedPhrase {
  std::string phrase;
  // How much more probable it is than any other speech, as a logarithm.
  double score = 0;
};

// The only place that knows PocketSphinx. Movable; a moved-from one may only be
// destroyed.
class SphinxDecoder {
public:
  // Whether an utterance that has ended is searched again, with all that was
  // kept: some 2 % of its time, for a third fewer errors of a domain model.
  enum class Passes { one, three };

  // Nothing, or an error that says what to install.
  static Expected<void> is_built_in();

  // `model` is the folder of the acoustic model; `dictionary` the text of a
  // dictionary, with every word that will be used.
  static Expected<SphinxDecoder> make(const std::string& model,
                                      const std::string& dictionary,
                                      Passes passes = Passes::one);

  SphinxDecoder(SphinxDecoder&&) noexcept;
  SphinxDecoder& operator=(SphinxDecoder&&) noexcept;
  ~SphinxDecoder();

  // Adds a search of this name, or replaces it. Not within an utterance.
  Expected<void> add_grammar(const std::string& name, const std::string& fsg);
  Expected<void> add_domain(const std::string& name, const std::string& arpa);
  // Phrases with their thresholds, a line each, as PocketSphinx reads them: "oh
  // mighty computer /1e-20/".
  Expected<void> add_keywords(const std::string& name,
                              const std::string& keywords);

  // Begins an utterance with one of the searches. One that is open is dropped.
  Expected<void> begin(const std::string& search);
  void hear(std::span<const Sample> audio);
  // What was heard so far.
  std::string text() const;
  // The phrases of a search for keywords that were found so far.
  std::vector<SpottedPhrase> spotted() const;
  // Ends the utterance. The words without those of silence and noise.
  std::vector<HeardWord> finish();
  void drop();

private:
  struct Implementation;

  explicit SphinxDecoder(std::unique_ptr<Implementation> implementation);

  std::unique_ptr<Implementation> implementation_;
};

} // namespace parlour::adapters::asr
