// NluEngine understands utterances by grammars, by names and values, and by
// what it has learnt from examples (docs/understanding.md). What grammars
// understood well stands; what was learnt completes the rest.
//
//  auto engine = NluEngine::build(model, columns, {.threshold = 0.4});
//  const auto made = engine->understand("a cab for half past five");
//  // made.acts: [{topic: "Taxi", act: "inform", slots: {Time: …}, …}]
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "adapters/nlu/grammar/example_file.hpp"
#include "adapters/nlu/grammar/synonyms.hpp"
#include "adapters/nlu/understand/language_knowledge.hpp"
#include "adapters/nlu/understand/understood.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

struct BuiltAct;
struct SentenceApart;
struct Utterance;

// Immutable; any number of threads may use it. Copies share what was built.
class NluEngine {
public:
  struct Options {
    double threshold = 0.4;
    // The platform's grammars: yes, no, help …
    std::vector<GrammarModel> generic;
    // By which words that no grammar has are understood.
    std::vector<SynonymGroup> synonyms = {};
    // What people say; it is learnt, and becomes no rule.
    std::vector<Wording> wordings = {};
    // Sentences that are about nothing of any application.
    std::vector<std::string> other_talk = {};
    // By which what is learnt is more than the words of the examples.
    LanguageKnowledge language = {};

    bool operator==(const Options& other) const = default;
  };

  // Compiles grammars, reads columns and learns examples, which may take
  // seconds. Returns all errors if there are any. `taught` may be an engine of
  // the same model and options: what it has learnt is taken over, though
  // columns have other values by now.
  static tl::expected<NluEngine, std::vector<Error>>
  build(const UnderstandingModel& model, const ColumnReader& columns,
        const Options& options, const NluEngine* taught = nullptr);

  // `context` is the map that comes with DoNLU, or unknown. Of what it says was
  // heard, another text may be understood, where it makes clearly more sense.
  Understanding understand(std::string_view text, const Value& context = {},
                           bool explain = false) const;

  // Whether one is a copy of the other.
  bool operator==(const NluEngine&) const = default;

private:
  struct Implementation;
  struct Taught;
  using SharedTaught = std::shared_ptr<const Taught>;

  static Expected<SharedTaught> teach(const UnderstandingModel& model,
                                      const Schema& schema,
                                      const Automaton& automaton,
                                      const Options& options);

  Understanding read(std::string_view text, const Value& context,
                     bool explain) const;
  void read_sentences(const Utterance& meant, const std::vector<BuiltAct>& acts,
                      const Value& context_value, Understanding& made) const;
  void read_alone(const std::vector<SentenceApart>& sentences,
                  const Value& context, Understanding& made) const;
  explicit NluEngine(std::shared_ptr<const Implementation> implementation);

  std::shared_ptr<const Implementation> implementation_;
};

} // namespace parlour::adapters::nlu
