// Filters take out islands that say what nobody means: values that only look
// like one, and what is named in passing (understanding, "Guesses and certain
// values").
#pragma once

#include <vector>

#include "adapters/nlu/parse/islands.hpp"

namespace parlour::adapters::nlu {

// Takes out values that the words only sound like, or that may be one of
// several, where others of the same slot are said as they are: in "what am I
// saying, Kelvin Palmer", "saying" is nobody called Seng, and in "Tan, Tan Wei
// Ming" nobody is asked which Tan.
void leave_out_guesses(std::vector<Island>& islands, const Spans& spans,
                       const Schema& schema);

// Takes out what only names something unknown, without saying what is wanted of
// it, where another clause names what is known: in "to the study, it's on the
// way", nobody asks for a way. Nor for a person in "where can I have a drink
// with clients": what is written as no name is, beside another topic's rule or
// before the sentence that says what is wanted ("my head is splitting. Where
// …"), with known values, too, if the conversation is about something else.
void leave_out_strangers(std::vector<Island>& islands,
                         const Utterance& utterance, const Spans& spans,
                         const Context& context);

// Takes out what names something unknown that no name is: a verb that rules
// know ("is there anywhere I could buy some"), or a word such as "moment".
void leave_out_unnamed(std::vector<Island>& islands, const Utterance& utterance,
                       const Spans& spans);

// Takes out values that are only alike, or named in part, where another
// sentence says what is wanted: in "we left home at six. Where is the bank?",
// nobody asks for the shop Star Home. What only sounds like a value goes
// wherever it stands, a day that is over where it is in another sentence ("he
// rang me yesterday"), and also where a yes or no was asked for. So do generic
// acts of which a clause has only the words (clause_filters).
void leave_out_stories(std::vector<Island>& islands, const Utterance& utterance,
                       const Spans& spans, const Context& context);

// Takes out an act about the conversation that is a part of what a rule of the
// application says: "stop" in "the bus stop".
void leave_out_acts_inside(std::vector<Island>& islands,
                           const Utterance& utterance, const Spans& spans);

// A value that is all that was said means something, though its words are plain
// ones: "Coffee?". Not a number or time: without a question they are anything.
void trust_whole_values(std::vector<Island>& islands,
                        const Utterance& utterance, const Spans& spans);

// Takes out what is about a part of another topic that does not go on.
void leave_out_parts(std::vector<Island>& islands, const Schema& schema,
                     const Context& context);

} // namespace parlour::adapters::nlu
