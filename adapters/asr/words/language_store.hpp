// LanguageStore remembers the language that was made last. The same one is
// wanted again and again: by each conversation of a test, by several instances
// of a recogniser, and after a reload that left grammars and values as they
// were. To make one takes seconds, to find it some milliseconds.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "adapters/asr/words/language.hpp"

namespace parlour::adapters::asr {

// Immutable, for any number of threads.
struct MadeLanguage {
  explicit MadeLanguage(const LanguageSources& sources);

  // The domain model in the ARPA format, and as packed() writes it; empty if
  // nothing is said. Takes some tenths of a second, the packed one only once.
  std::string arpa() const;
  const std::string& packed_model() const;

  Language language;
  TrigramCounts counts;

private:
  mutable std::once_flag once_;
  mutable std::string packed_;
};

// Thread-safe. Where several threads want the same language that is not there
// yet, each makes it.
class LanguageStore {
public:
  // Columns are read in any case, and twice where they have changed, since a
  // language knows the values that they had when it was made: the reader of
  // the sources should remember them (KnownColumns). Blocks for up to some
  // seconds.
  std::shared_ptr<const MadeLanguage> get(const LanguageSources& sources);

private:
  // A language, and all that it was made from.
  struct Kept {
    LanguageSources sources; // without their reader of columns
    // Nothing: it could not be read.
    std::map<std::string, std::optional<std::vector<std::string>>> columns;
    std::shared_ptr<const MadeLanguage> made;

    bool is_of(const LanguageSources& wanted) const;
  };

  std::shared_ptr<const Kept> kept() const;
  void keep(std::shared_ptr<const Kept> latest);

  mutable std::mutex mutex_;
  std::shared_ptr<const Kept> kept_;
};

// The store of this process.
LanguageStore& language_store();

} // namespace parlour::adapters::asr
