// The value sets of an application: names and other values of its slots and
// database columns, and forms such as times, each as a graph of words.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/asr/words/word_graph.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::asr {

// How words are written: "Jeffery", though it is said like "jeffery". The first
// spelling with capitals counts, unless the word is also written without.
// Of a whole application. A recogniser hears small letters only.
class Spellings {
public:
  // Notes the words of a text. `is_sentence`: its first word has a capital
  // anyway, which says nothing.
  void note(std::string_view text, bool is_sentence);
  std::string written(const std::string& word) const;

private:
  struct Spelling {
    std::string written;
    bool small = false;
  };
  std::map<std::string, Spelling> spellings_;
};

// Used while a Language is made, on its thread.
class ValueSets {
public:
  // `symbols` and `spellings` must outlive this.
  ValueSets(const UnderstandingModel& model, ColumnReader columns,
            Symbols& symbols, Spellings& spellings);

  // The set that `@…` of a grammar refers to: a slot, a column, a form, or
  // "words". `slot` is the slot that the words fill, if any. Reads columns.
  Symbol set_of(std::string_view reference, std::string_view slot = {});
  // That of a slot.
  Symbol set_of(const TopicModel& topic, const SlotModel& slot);

  // Adds a value, such as one that an example or a conversation gives.
  void add(Symbol set, std::string_view value);
  // What is said of any slot of this name when any words will do.
  Symbol open_set(std::string_view slot);
  // Where a form is put together from other words.
  GraphBuilder& builder(Symbol set) {
    return builders_[set];
  }
  Symbol form(std::string_view name);

  // All values of a set in spoken words; empty for a form.
  const std::vector<std::vector<Symbol>>& values(Symbol set) const;
  std::map<Symbol, WordGraph> graphs() const;
  // Columns that could not be read.
  const std::vector<Error>& errors() const {
    return errors_;
  }

private:
  Symbol column(const std::string& name);

  const UnderstandingModel& model_;
  ColumnReader columns_;
  Symbols& symbols_;
  Spellings& spellings_;
  std::map<Symbol, GraphBuilder> builders_;
  std::map<Symbol, std::vector<std::vector<Symbol>>> values_;
  std::map<std::string, Symbol> read_columns_;
  std::vector<Error> errors_;
};

} // namespace parlour::adapters::asr
