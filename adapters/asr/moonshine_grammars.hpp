// What MoonshineASR knows of an application's grammars: which words a turn that
// is narrowed to some of them prefers, and whether a sentence may end where
// somebody pauses.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "adapters/asr/moonshine_frames.hpp"
#include "adapters/asr/words/language_store.hpp"

namespace parlour::adapters::moonshine {

// For one thread.
// The instance is replaced as a whole when a column has new values.
class MoonshineGrammars {
public:
  explicit MoonshineGrammars(std::shared_ptr<const asr::MadeLanguage> made)
      : made_(std::move(made)) {}

  // The phrases of these grammars, rules, slots, columns or forms, and of what
  // is said in any conversation; null if no name is known.
  const Words* words(const std::vector<std::string>& names);

  // Whether a sentence of the grammars may end with this text, as the
  // recogniser writes it; of all of them if no name is known. Nothing if none
  // begins so.
  std::optional<bool> ends(const std::vector<std::string>& names,
                           const std::string& text);

  // What the recogniser writes as people type it, with names as the application
  // has them.
  std::string typed(std::string_view text) const;

  // Which words follow each other in all of them, as the program reads it;
  // empty if there are none. Takes some tenths of a second the first
  // time.
  const std::string& domain_model() const {
    return made_->packed_model();
  }

private:
  // What was prepared for one list of names.
  struct Narrow {
    std::vector<std::string> names;
    std::optional<asr::WordGraph> graph; // nothing: no name is known
    Words words;
  };
  const Narrow& narrow(const std::vector<std::string>& names);

  const asr::Language& language() const {
    return made_->language;
  }

  std::shared_ptr<const asr::MadeLanguage> made_;
  std::vector<Narrow> known_; // a few
};

} // namespace parlour::adapters::moonshine
