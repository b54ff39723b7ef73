// The matcher finds the parts of an utterance that a rule of the grammars
// describes. It runs the automaton from every token at once. A partial match
// may skip words that the rule does not have, so "book, er, a quiet room" fits
// the rule "book a room".
//
// The score of a match is a sum:
//
//  + the weight of each word of the rule that was said (Utterance::weight)
//  + the gain of each value (Span::gain)
//  - for each word that was skipped, and for punctuation within the match
//  - for an unlikely alternative of the grammar (Arc::weight)
//  + the bias of the rule (RuleInfo::bias)
//
// The work is bounded by tokens x partial matches kept at a token x arcs that
// fit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/nlu/grammar/automaton.hpp"
#include "adapters/nlu/parse/spans.hpp"

namespace parlour::adapters::nlu {

// What happened on the way to a match, as a linked list with the newest entry
// first. Partial matches share the beginning of their lists.
struct Trace {
  enum class Kind : std::uint8_t { open, close, span };

  // The index of the previous entry; 0: none.
  std::uint32_t before = 0;
  // The number of the tag, or of the span.
  std::uint32_t what = 0;
  std::uint32_t position = 0;
  Kind kind = Kind::open;
};

// A rule that describes the tokens [begin, end).
struct Match {
  std::uint32_t rule = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  float score = 0;
  // The weight of the words that were understood.
  float covered = 0;
  std::uint32_t trace = 0;
  // A value that counts only if one is expected, such as after a correction
  // ("no, four").
  bool weak = false;
  // How many slots were filled on the way.
  std::uint8_t filled = 0;
};

// One search of one utterance. Refers to its arguments, which must outlive it.
class Matcher {
public:
  // `asked` is the entity that the context asks for, or asked_entity if it asks
  // for none. `grammar` is the only grammar to be tried besides generic acts;
  // empty: all.
  Matcher(const Automaton& automaton, const Utterance& utterance, Spans& spans,
          EntityId asked, std::string grammar = {});

  // Returns the matches, ordered by their end. Call it once.
  std::vector<Match> run();

  const std::vector<Trace>& traces() const {
    return traces_;
  }
  // The number of arcs that were tried, for tests of the bound.
  std::size_t work() const {
    return work_;
  }

private:
  // A partial match that has reached a token.
  struct Item {
    std::uint32_t state = 0;
    std::uint32_t begin = 0;
    // Behind the last token that was taken.
    std::uint32_t last = 0;
    std::uint32_t trace = 0;
    float score = 0;
    float covered = 0;
    // How many words of the grammar were taken.
    std::uint8_t words = 0;
    // How many tokens were skipped since the last one was taken.
    std::uint8_t skipped = 0;
    bool weak = false;
    std::uint8_t filled = 0;
    // A "not" was skipped.
    bool denied = false;
  };

  // What a rule may take: the bits of words, and of entities at its beginning
  // and behind a word of its own.
  struct Takes {
    std::uint64_t words = 0;
    std::uint64_t first = 0;
    std::uint64_t behind_word = 0;

    std::uint64_t entities(const Item& item) const {
      return item.words > 0 ? behind_word : first;
    }
  };

  // What skipping a token costs.
  struct Skip {
    float cost = 0;
    bool counts = false;
    bool denies = false; // it is a "not"
  };

  void carry(const Item& item, std::size_t position);
  static void limit(std::vector<Item>& items);
  // The ways to go on from a token: take a word, take a value, skip the token.
  void step(std::size_t position, const Item& item);
  void skip(std::size_t position, const Item& item);
  void take_word(std::size_t position, const Item& item);
  void follow_word(std::size_t position, const Item& item, WordNumber word,
                   float cost);
  void take_entities(std::size_t position, const Item& item);
  void take_entity(std::size_t position, const Item& item, const Arc& arc);
  void take_span(const Item& item, const Arc& arc, std::uint32_t index,
                 bool expected);
  void reach(const Item& item, std::size_t position);
  Takes takes_at(std::size_t position) const;
  Takes takes_from(std::size_t position) const;
  Skip skip_of(std::size_t position) const;
  bool may_go_on(const Item& item, std::size_t position) const;
  void accept(const Item& item, const Accept& accept);
  bool is_tried(const RuleInfo& rule) const;
  // Records the actions of an arc that is taken next.
  void follow(Item& item, std::uint32_t actions, std::uint32_t open_at);
  std::uint32_t push(Trace trace);

  const Automaton& automaton_;
  const Utterance& utterance_;
  Spans& spans_;
  EntityId asked_;
  std::string grammar_;
  // By token: what may be taken there, and from there on before too many are
  // skipped; nothing behind the last one.
  std::vector<Takes> here_;
  std::vector<Takes> ahead_;
  std::vector<Skip> skips_; // by token
  // By the token that comes next.
  std::vector<std::vector<Item>> items_;
  // Is used again, which asks for less memory.
  std::vector<Item> spare_;
  // By end.
  std::vector<std::vector<Match>> found_;
  std::vector<Trace> traces_;
  std::size_t work_ = 0;
};

} // namespace parlour::adapters::nlu
