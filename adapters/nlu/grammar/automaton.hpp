// All grammars of an application as one finite automaton, whose symbols are
// words and entities (values). It has no empty moves, so each step of the
// matcher takes a word or a value. It is not deterministic: several arcs of a
// state may take the same word.
//
// Grammars assign meaning by tags. An arc carries actions that open and close
// tags; the matcher records them, and islands.hpp reads the meaning from the
// record.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "adapters/nlu/values/schema.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters::nlu {

// Numbers of words in the vocabulary, from 1.
using WordNumber = std::uint32_t;
// A word of no grammar; no arc has it.
inline constexpr WordNumber unknown_word = 0;

// What a tag says: the value of a slot, the act, the topic, the value of the
// slot that the context asks for, or that the value which follows is not
// wanted.
enum class TagKind : std::uint8_t { slot, act, topic, asked, denies };

// Whether it takes the words between its opening and its closing. Of others
// only the closing counts.
constexpr bool has_extent(TagKind kind) {
  return kind == TagKind::slot || kind == TagKind::asked;
}

struct TagInfo {
  TagKind kind = TagKind::slot;
  // The name of the slot, or the act.
  std::string name;
  // The topic of a qualified slot ({Topic.Slot}), or the topic itself.
  TopicNumber topic = no_topic;
  // Whether the tag has a value of its own ({Slot=value}) instead of the words.
  bool has_value = false;
  Value value;
};

// What happens along an arc, before its word is taken: a tag is opened or
// closed.
struct Action {
  std::uint32_t tag = 0;
  bool opens = false;

  bool operator==(const Action&) const = default;
  bool operator<(const Action& other) const {
    return tag != other.tag ? tag < other.tag : opens < other.opens;
  }
};

struct Arc {
  // A word number or an EntityId.
  std::uint32_t symbol = 0;
  // The number of a list in Automaton::actions.
  std::uint32_t actions = 0;
  std::uint32_t target = 0;
  // Added to the score; never above 0.
  float weight = 0;
};

// A rule that is complete in this state.
struct Accept {
  std::uint32_t rule = 0;
  std::uint32_t actions = 0;
  float weight = 0;

  bool operator==(const Accept&) const = default;
};

// One of 64 bits for each word, by which a set of words is known not to have
// one.
constexpr std::uint64_t word_bit(WordNumber word) {
  return std::uint64_t{1} << ((word * 0x9e3779b97f4a7c15) >> 58);
}

// The arcs of words are sorted by word, for binary search. The arcs of entities
// keep the order of the grammar; of equally good ones the first wins.
struct State {
  std::vector<Arc> words;
  std::vector<Arc> entities;
  std::vector<Accept> accepts;
  // The bits of the words and of the entities.
  std::uint64_t word_bits = 0;
  std::uint64_t entity_bits = 0;
};

struct RuleInfo {
  // As it is shown: "<grammar.rule>".
  std::string name;
  std::string grammar;
  // The topic of the whole grammar, if it has one.
  TopicNumber topic = no_topic;
  // Of the platform's grammar of yes, no, help …
  bool generic = false;
  // A value and nothing else.
  bool bare = false;
  // Added to the score of each match.
  float bias = 0;
};

// Built by AutomatonBuilder, then only read, by any number of threads.
struct Automaton {
  TextMap<WordNumber> vocabulary;
  // The words of the vocabulary as which a word may be read besides itself
  // (synonyms.hpp), whether it is in the vocabulary or not.
  using Synonyms = std::vector<WordNumber>;
  TextMap<Synonyms> synonyms;
  // Hesitations that are words of the application's own: "ER".
  std::set<std::string, std::less<>> own_hesitations;
  // State 0 is the start of every rule.
  std::vector<State> states;
  // Lists of actions, to which arcs refer by number. List 0 is empty.
  std::vector<std::vector<Action>> actions;
  std::vector<TagInfo> tags;
  std::vector<RuleInfo> rules;
  // The entities that arcs take, sorted.
  std::vector<EntityId> entities;

  WordNumber word(std::string_view text) const {
    const auto found = vocabulary.find(text);
    return found == vocabulary.end() ? unknown_word : found->second;
  }
  // Null where it has none.
  const Synonyms* synonyms_of(std::string_view text) const {
    const auto found = synonyms.find(text);
    return found == synonyms.end() ? nullptr : &found->second;
  }
};

// The arcs that take this symbol. `arcs` must be sorted by symbol.
std::span<const Arc> arcs_of(const std::vector<Arc>& arcs,
                             std::uint32_t symbol);

} // namespace parlour::adapters::nlu
