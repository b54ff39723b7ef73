// LanguageKnowledge is what understanding knows of the language beside an
// application: files of the platform's folder that `tools/dependencies words`
// and `tools/dependencies sentences` make. All works without them, only with
// more examples (docs/understanding.md).
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

#include "adapters/nlu/encoder/sentence_encoder.hpp"
#include "adapters/nlu/learning/word_vectors.hpp"

namespace parlour::adapters::nlu {

struct LanguageKnowledge {
  // By which words that mean the same are understood; may be none.
  std::shared_ptr<const WordVectors> vectors = {};
  // By which sentences that mean the same are understood; may be none.
  std::shared_ptr<const SentenceEncoder> encoder = {};
  // Where it is kept what the encoder makes of texts; empty: nowhere.
  std::filesystem::path known_sentences = {};

  // The same if their files are.
  bool operator==(const LanguageKnowledge& other) const;
};

// LanguageStore remembers what was read last, since each start and check of an
// application wants it again. Thread-safe.
class LanguageStore {
public:
  // Whatever of it is in the platform's folder. A file that changed is read
  // again.
  LanguageKnowledge read(const std::filesystem::path& platform,
                         std::vector<Error>& errors);

private:
  template <class Knowledge>
  struct Kept {
    std::filesystem::path path;
    std::filesystem::file_time_type written;
    std::shared_ptr<const Knowledge> knowledge;
  };

  template <class Knowledge>
  std::shared_ptr<const Knowledge> read(Kept<Knowledge>& kept,
                                        const std::filesystem::path& path,
                                        std::vector<Error>& errors);

  std::mutex mutex_;
  Kept<WordVectors> vectors_;
  Kept<SentenceEncoder> encoder_;
};

// The store of this process.
LanguageStore& language_store();

} // namespace parlour::adapters::nlu
