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
};

// Whether the fill's value is nothing but words.
bool is_open(const Fill& fill, const Spans& spans);

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
  const Fill* find(std::string_view slot) const;
};

// Reads all matches that the context allows. A match that fills slots of
// different topics makes no sense and is left out.
std::vector<Island> read_islands(const std::vector<Match>& matches,
                                 const std::vector<Trace>& traces,
                                 const Spans& spans, const Automaton& automaton,
                                 const Schema& schema, const Context& context);

// Takes out values that the words only sound like, where others of the same
// slot are said as they are: in "what am I saying, Kelvin Palmer", "saying" is
// nobody called Seng.
void leave_out_guesses(std::vector<Island>& islands, const Spans& spans,
                       const Schema& schema);

// Takes out what only names something unknown, without saying what is wanted of
// it, where another clause names what is known: in "to the study, it's on the
// way", nobody asks for a way. Nor for a person in "where can I have a drink
// with clients": what is written as no name is, beside another topic's rule.
void leave_out_strangers(std::vector<Island>& islands,
                         const Utterance& utterance, const Spans& spans);

// Takes out what names something unknown that no name is: a verb that rules
// know ("is there anywhere I could buy some"), or a word such as "moment".
void leave_out_unnamed(std::vector<Island>& islands, const Utterance& utterance,
                       const Spans& spans);

// Takes out values that are only alike, or named in part, where another
// sentence says what is wanted: in "we left home at six. Where is the bank?",
// nobody asks for the shop Star Home. What only sounds like a value goes
// wherever it stands, and also where a yes or no was asked for.
void leave_out_stories(std::vector<Island>& islands, const Utterance& utterance,
                       const Spans& spans, const Context& context);

// A value that is all that was said means something, though its words are plain
// ones: "Coffee?". Not a number or time: without a question they are anything.
void trust_whole_values(std::vector<Island>& islands,
                        const Utterance& utterance, const Spans& spans);

// Takes out what is about a part of another topic that does not go on.
void leave_out_parts(std::vector<Island>& islands, const Schema& schema,
                     const Context& context);

} // namespace parlour::adapters::nlu
