// An island is what a part of the utterance says: the meaning of a match, read
// from the tags on its way. Between islands lie words that no rule describes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/nlu/parse/context.hpp"
#include "adapters/nlu/parse/matcher.hpp"

namespace parlour::adapters::nlu {

// The value of one slot.
struct Fill {
  std::string slot;
  // Set if the slot can only belong to this topic.
  TopicNumber topic = no_topic;
  // The value is that of a span, or else the literal, or else the words.
  std::optional<std::uint32_t> span;
  std::optional<Value> literal;
  std::uint32_t begin = 0; // tokens
  std::uint32_t end = 0;
  // Any words: neither of a list nor of a normal form.
  bool open = false;
  // The words name the slot, and give no value.
  bool is_name = false;
};

// Whether the fill's value is nothing but words.
bool is_open(const Fill& fill, const Spans& spans);

// Whether its words stand for a value that there is not.
bool is_unmatched(const Fill& fill, const Spans& spans);

struct Island {
  const RuleInfo* rule = nullptr;
  std::uint32_t begin = 0; // tokens
  std::uint32_t end = 0;
  double score = 0;
  double covered = 0;
  bool weak = false;
  // Fills the slot that was asked for.
  bool asked = false;
  // What follows is not wanted.
  bool denies = false;
  // Empty if the rule says none.
  std::string act;
  // The topics that it may be about; empty for a generic act.
  std::vector<TopicNumber> topics;
  std::vector<Fill> fills;

  // "no", "sorry, I mean": corrects what stands before or comes after.
  bool is_marker() const {
    return topics.empty() && (act == "deny" || act == "correct");
  }
  // Whether it is about a topic.
  bool is_content() const {
    return !topics.empty();
  }
  // Yes or no, about no topic.
  bool is_answer() const {
    return !is_content() && (act == "confirm" || act == "deny");
  }
  // "…, isn't it?": says nothing of its own.
  bool is_tag() const {
    return rule->generic && rule->name == "<generic-acts.tag_question>";
  }
  const Fill* find(std::string_view slot) const;
};

// Leaves out those of which it holds. All are judged before one is removed.
template <class Predicate>
void leave_out(std::vector<Island>& islands, const Predicate& is_out) {
  std::vector<bool> out;
  out.reserve(islands.size());
  for (const auto& island : islands)
    out.push_back(is_out(island));
  std::size_t at = 0;
  std::erase_if(islands, [&](const Island&) { return out[at++]; });
}

// Takes from each island the topics of which `is_out(island, topic)` holds, and
// the island with the last of them.
template <class Predicate>
void leave_out_topics(std::vector<Island>& islands, const Predicate& is_out) {
  std::erase_if(islands, [&](Island& island) {
    const bool content = island.is_content();
    std::erase_if(island.topics,
                  [&](TopicNumber topic) { return is_out(island, topic); });
    return content && !island.is_content();
  });
}

// Whether the one ends before the sentence in which the other begins.
bool is_before_sentence(const Island& one, const Island& other,
                        const Tokens& tokens);

// Reads all matches that the context allows. A match that fills slots of
// different topics makes no sense and is left out.
std::vector<Island> read_islands(const std::vector<Match>& matches,
                                 const std::vector<Trace>& traces,
                                 const Spans& spans, const Automaton& automaton,
                                 const Schema& schema, const Context& context);

} // namespace parlour::adapters::nlu
