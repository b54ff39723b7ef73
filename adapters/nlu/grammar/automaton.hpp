// All grammars of an application as one automaton over word numbers and
// entities, without empty moves. Built once (automaton_builder.hpp), then only
// read; any number of threads may match with it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "adapters/nlu/values/schema.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters::nlu {

using WordNumber = std::uint32_t;
inline constexpr WordNumber unknown_word = 0; // no arc has it

// A slot's value; the act; the topic; the slot that the context asks for; that
// what follows is what the user does not want.
enum class TagKind : std::uint8_t { slot, act, topic, asked, denies };

struct TagInfo {
  TagKind kind = TagKind::slot;
  std::string name;             // of the slot, or the act
  TopicNumber topic = no_topic; // of a qualified slot, or the topic itself
  bool has_value = false;
  Value value;
};

// What happens on the way along an arc, before its word is taken.
struct Action {
  std::uint32_t tag = 0;
  bool opens = false; // else the tagged part ends here

  auto operator<=>(const Action&) const = default;
};

struct Arc {
  std::uint32_t symbol = 0; // word number or entity
  std::uint32_t actions = 0;
  std::uint32_t target = 0;
  float weight = 0; // added to the score; 0 or below
};

struct Accept {
  std::uint32_t rule = 0;
  std::uint32_t actions = 0;
  float weight = 0;
};

// Arcs of words are sorted by word; those of entities stand in the grammar's
// order, and of equally good ones the first wins.
struct State {
  std::vector<Arc> words;
  std::vector<Arc> entities;
  std::vector<Accept> accepts;
};

struct RuleInfo {
  std::string name; // as it is printed: "<grammar.rule>"
  std::string grammar;
  TopicNumber topic = no_topic; // where the grammar as a whole has one
  bool generic = false;         // of the platform's grammar
  bool bare = false;            // a value and nothing else
  float bias = 0;
};

struct Automaton {
  TextMap<WordNumber> vocabulary;
  std::vector<State> states; // the first is the start of every rule
  std::vector<std::vector<Action>> actions; // the first is empty
  std::vector<TagInfo> tags;
  std::vector<RuleInfo> rules;
  std::vector<EntityId> entities; // that arcs take, sorted

  WordNumber word(std::string_view text) const {
    const auto found = vocabulary.find(text);
    return found == vocabulary.end() ? unknown_word : found->second;
  }
};

// The arcs of a state that take this symbol.
std::span<const Arc> arcs_of(const std::vector<Arc>& arcs,
                             std::uint32_t symbol);

} // namespace parlour::adapters::nlu
