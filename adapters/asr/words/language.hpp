// Language: what an application's users say, made from the application itself:
// its grammars, value sets, columns, examples and conversations. From it come
// the recogniser's grammar, its domain model and its words.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "adapters/asr/words/conversations.hpp"
#include "adapters/asr/words/fsg_text.hpp"
#include "adapters/asr/words/grammar_reader.hpp"
#include "adapters/asr/words/trigrams.hpp"
#include "adapters/asr/words/value_sets.hpp"
#include "adapters/asr/words/word_graph.hpp"
#include "adapters/nlu/grammar/example_file.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::asr {

// All of it may be empty: then nothing can be heard.
struct LanguageSources {
  UnderstandingModel model;
  ColumnReader columns;
  // What people say in any conversation: yes, no, help.
  std::optional<GrammarModel> generic;
  // How times, numbers and the like are said: a public rule for each form.
  std::optional<GrammarModel> forms;
  Conversations conversations;
  // What people say for their topics in other words. Only the domain model
  // learns them: as sentences of the grammar they would be heard everywhere.
  std::vector<nlu::Wording> wordings = {};
};

// Immutable after it was made; then any number of threads may use it.
//
// An example: for "where is [the] @Facility.Name" the graph has "where is the"
// and the value set; the set's names are a graph of their own. From both come
// the recogniser's grammar, and the sentences that are drawn for the domain
// model.
//
//   grammars, examples, conversations -> GrammarReader -> parts_ (word graphs)
//   values of slots, columns, forms   -> ValueSets     -> sets_ (word graphs)
//   parts_ and sets_ -> fsg():  all sentences, as the decoder reads them
//                    -> counts(): drawn sentences, for Trigrams
//                    -> ends(): whether what was heard may be all
class Language {
public:
  // Takes a second or less. Parts with errors are left out: the understanding
  // reports them.
  explicit Language(const LanguageSources& sources);

  // The graph of sentences: of all, or of what these names stand for: grammars,
  // their public rules, slots (Topic.Slot), columns, forms. Generic sentences
  // always belong. Nothing if no name is known.
  const WordGraph& sentences() const {
    return sentences_;
  }
  std::optional<WordGraph>
  sentences(const std::vector<std::string>& names) const;

  // What is more than the decoder can hold is left out (FsgText::is_whole).
  FsgText fsg(const WordGraph& graph) const;
  // What the domain model is made of, counted from `count` of all sentences, as
  // many of the application's own, the wordings, and the conversations.
  TrigramCounts counts(std::size_t count) const;
  const Symbols& symbols() const {
    return symbols_;
  }
  // What the graph's sentences are made of, as it is written: the values in
  // them, at most so many, and single words. Forms such as times are left out.
  struct Phrases {
    std::vector<std::string> values;
    std::vector<std::string> words;
  };
  Phrases phrases(const WordGraph& graph, std::size_t most_values) const;
  // All words that may be heard.
  std::set<std::string> words() const;
  // "Jeffery" for "jeffery".
  std::string written(const std::string& word) const {
    return spellings_.written(word);
  }

  // Whether the words are a whole sentence, or several; false if a sentence
  // begins so but cannot end there; nothing if none begins so.
  std::optional<bool> ends(const WordGraph& graph,
                           const std::vector<std::string>& words) const;

private:
  void add_values(const WordGraph& set, std::uint32_t state,
                  const std::string& before, std::size_t most,
                  std::vector<std::string>& values) const;
  void add_example_values(const TopicModel& topic, ValueSets& sets);
  void add_conversations(const LanguageSources& sources, ValueSets& sets);
  void add_wordings(const LanguageSources& sources, ValueSets& sets);
  void add_grammar(const GrammarModel& model, GrammarReader& reader);
  void add_examples(const TopicModel& topic, GrammarReader& reader,
                    GraphBuilder& to);
  void add_bare_values(const UnderstandingModel& model, ValueSets& sets);
  // Only parts are read; what they make together comes last.
  // Fills `own_` and `sentences_` from the parts.
  void put_together();
  // One graph that has the sentences of all of them, contracted ones too.
  WordGraph joined(const std::vector<const WordGraph*>& graphs) const;

  Symbols symbols_;
  Spellings spellings_;
  std::map<Symbol, WordGraph> sets_;
  WordGraph sentences_;
  WordGraph generic_;
  WordGraph own_; // without the platform's
  // The contractions of this language, as symbols.
  struct Contraction {
    Symbol first;
    Symbol second;
    Symbol both;
  };
  std::vector<Contraction> contractions_;
  // Grammars and public rules, slots, columns and forms by name.
  std::map<std::string, WordGraph> parts_;
  // Examples and lines of conversations, word by word.
  std::vector<std::vector<Symbol>> said_;
  // Wordings, with value sets in their marked places.
  std::vector<std::vector<Symbol>> wordings_;
};

} // namespace parlour::adapters::asr
