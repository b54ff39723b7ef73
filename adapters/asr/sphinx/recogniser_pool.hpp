// RecogniserPool: the recognisers of a component, and what they can hear. They
// are made when they are needed. Where a column has new values, others take
// their place; who is being heard meanwhile is heard to the end by an old one.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adapters/asr/sphinx/hearing.hpp"
#include "adapters/loop/loop.hpp"
#include "adapters/nlu/values/known_columns.hpp"

namespace parlour::adapters::asr {

// For one thread, beside `renewed` of prepare().
//
// Each Hearing belongs to the vocabulary that it was made with: one that comes
// back after another vocabulary is in use is thrown away.
//
// New values of a column, step by step: set_values() notes them, renew() makes
// a vocabulary and a first recogniser of them elsewhere, use() puts both in
// place, and give_back() throws the old ones away as they come.
class RecogniserPool {
public:
  // Makes the vocabulary and the first recogniser. Blocks for a second or so.
  static Expected<std::unique_ptr<RecogniserPool>>
  make(LanguageSources sources, const std::string& model, std::size_t most);

  // Nothing can be heard: the application says nothing of its language.
  bool is_deaf() const {
    return is_deaf_;
  }
  // Whether all sentences of the application can be heard in a turn.
  bool is_whole() const {
    return vocabulary_->is_whole;
  }
  // Nothing if all are busy, or one more cannot be made.
  std::optional<Hearing> take();
  void give_back(Hearing hearing);

  // Notes the values of a column; false if nothing is new.
  bool set_values(const std::string& column, const List& values);

  // What was made of new values.
  struct Renewed {
    std::shared_ptr<const Vocabulary> vocabulary;
    std::optional<Hearing> first; // nothing: it is deaf
  };
  using Outcome = std::shared_ptr<Expected<Renewed>>;
  // Makes another vocabulary of the present values: at once, or on the loop's
  // thread, where `made` is then called.
  Outcome renew() const;
  void renew(Loop& loop, std::function<void(Outcome)> made) const;
  // From now on it is used.
  void use(Renewed renewed);

private:
  RecogniserPool(LanguageSources sources, std::string model, std::size_t most);

  // May be called from any thread; refers to nothing here.
  using Maker = std::function<Expected<Renewed>()>;
  Maker maker() const;

  std::string model_;
  std::size_t most_;
  // Shared: the sources of the language refer to it.
  std::shared_ptr<nlu::KnownColumns> columns_;
  LanguageSources sources_;
  std::shared_ptr<const Vocabulary> vocabulary_;
  bool is_deaf_ = false;
  std::size_t made_ = 0; // of this vocabulary
  std::vector<Hearing> free_;
};

} // namespace parlour::adapters::asr
