// Compiles <phrases>: the words for what the engine says by itself
// (docs/understanding.md, "Phrases").
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// Every act that the engine says, with a sentence for each.
// clang-format off
#define PARLOUR_SAY_ACTS(X) \
  X(question, "asks for a slot") \
  X(reprompt, "asks again") \
  X(answer, "data: rows, asked, relaxed of an enquiry") \
  X(ambiguous, "data: candidates") \
  X(invalid, "data: value, reason, type, choices") \
  X(confirm, "asks whether a value is right; data: value") \
  X(offer, "asks whether what the slot offers is right; data: value, label, type") \
  X(summary, "asks whether all that is gathered is right; data: slots") \
  X(what_to_change, "asks what of it is wrong") \
  X(clarify, "asks which topic is meant; data: topics") \
  X(resume, "asks whether to take an unfinished topic up again") \
  X(choices, "what can be answered; data: choices") \
  X(person, "offers somebody to talk to") \
  X(help, "what can be said") \
  X(explain, "why a slot is asked for") \
  X(repeat_nothing, "there is nothing to repeat") \
  X(cancelled, "the topic was cancelled") \
  X(cancelled_all, "everything unfinished was cancelled") \
  X(already_done, "what is to be cancelled or mended is completed") \
  X(restarted, "everything begins again") \
  X(greet, "answers a greeting; data: asked") \
  X(bye, "answers a goodbye; data: unfinished") \
  X(thank, "answers thanks") \
  X(acknowledge, "what was said answers no question; data: missing") \
  X(one_by_one, "more was said than what was asked for") \
  X(wait, "the user asks for a moment") \
  X(protest, "the user has said it already") \
  X(refuse, "the user does not want to say it") \
  X(no_match, "nothing was understood; data: count") \
  X(no_input, "nothing was said; data: count") \
  X(unavailable, "a service is away; data: service") \
  X(apology, "an error ended what was being done")
// clang-format on

const std::vector<std::string>& say_acts();

// `functions`: those that the phrases see besides the session-wide ones; may be
// null.
void compile_phrases(const Element& phrases, const FunctionNames* functions,
                     Compilation& compilation);

} // namespace parlour::script
