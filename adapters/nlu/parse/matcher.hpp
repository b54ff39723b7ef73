// Finds islands: parts of an utterance that a rule of the grammars describes,
// with words between them that none does. The work is bounded by tokens times
// kept partial matches times the arcs that fit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/nlu/grammar/automaton.hpp"
#include "adapters/nlu/parse/spans.hpp"

namespace parlour::adapters::nlu {

// What happened on the way to an island, newest first.
struct Trace {
  enum class Kind : std::uint8_t { open, close, span };

  std::uint32_t before = 0; // 0: none
  std::uint32_t what = 0;   // tag or span
  std::uint32_t position = 0;
  Kind kind = Kind::open;
};

struct Match {
  std::uint32_t rule = 0;
  std::uint32_t begin = 0; // tokens
  std::uint32_t end = 0;
  float score = 0;
  float covered = 0;
  std::uint32_t trace = 0;
  // Only words that are a value where one is expected: counts after a
  // correction ("no, four").
  bool weak = false;
};

class Matcher {
public:
  // `asked` is the entity that the context asks for, or asked_entity; `grammar`
  // the only one besides generic acts that is tried, "" for all rules.
  Matcher(const Automaton& automaton, const Utterance& utterance, Spans& spans,
          EntityId asked, std::string grammar = {});

  std::vector<Match> run();

  const std::vector<Trace>& traces() const {
    return traces_;
  }
  // Arcs that were tried: for tests of the bounds.
  std::size_t work() const {
    return work_;
  }

private:
  struct Item {
    std::uint32_t state = 0;
    std::uint32_t begin = 0;
    std::uint32_t last = 0; // behind the last token taken
    std::uint32_t trace = 0;
    float score = 0;
    float covered = 0;
    std::uint8_t words = 0;   // of the grammar, taken
    std::uint8_t skipped = 0; // since the last one taken
    bool weak = false;
  };

  void tidy(std::vector<Item>& items) const;
  void step(std::size_t position, const Item& item);
  void skip(std::size_t position, const Item& item);
  void take_word(std::size_t position, const Item& item);
  void take_entities(std::size_t position, const Item& item);
  void take_entity(std::size_t position, const Item& item, const Arc& arc);
  void take_span(const Item& item, const Arc& arc, std::uint32_t index,
                 bool expected);
  void reach(Item item, std::size_t position);
  void accept(const Item& item, const Accept& accept);
  bool is_tried(const RuleInfo& rule) const;
  std::uint32_t follow(std::uint32_t trace, std::uint32_t actions,
                       std::uint32_t open_at, std::uint32_t close_at);
  std::uint32_t push(Trace trace);

  const Automaton& automaton_;
  const Utterance& utterance_;
  Spans& spans_;
  EntityId asked_;
  std::string grammar_;
  std::vector<std::vector<Item>> items_;  // by position
  std::vector<std::vector<Match>> found_; // by end
  std::vector<Trace> traces_;
  std::size_t work_ = 0;
};

} // namespace parlour::adapters::nlu
