// Where a value of a list belongs, words may stand that are none of it: "is
// there a sauna". Who says so may be told that there is none. But nearly any
// words can stand at such a place, so most sentences about something else would
// look like it (docs/understanding.md, "Values that nobody knows").
#pragma once

#include <vector>

#include "adapters/nlu/parse/built_act.hpp"
#include "adapters/nlu/parse/context.hpp"

namespace parlour::adapters::nlu {

// Takes out islands that have nothing but such a value, where it is unlikely
// that it is one, unless the conversation is about it.
void leave_out_unlikely_values(std::vector<Island>& islands,
                               const Utterance& utterance, const Spans& spans,
                               const Schema& schema, const Context& context);

// Takes out values that words only look or sound like and that stand alone
// beside words which mean something else: in "how can I root a phone", nobody
// asks for Ruth.
void leave_out_lookalikes(std::vector<Island>& islands,
                          const Utterance& utterance, const Spans& spans,
                          const Context& context);

// Whether the words only sound like a thing's name: "breathe" like the shop
// Bright Steps.
bool is_vague(const Span& span, const Schema& schema);

// Takes out islands with a value that is only like what is said, or named in
// part, where the words belong to a longer value: in "the lung clinic" nobody
// means the lung ward.
void leave_out_pieces_of_values(std::vector<Island>& islands,
                                const Spans& spans);

// Takes out islands with such a value that have the words of a known value of
// the slot that was asked for, and are about what nobody expects: "305, and
// anytime soon" is no name of a guest where the room is asked for.
void leave_out_rivals_of_answers(std::vector<Island>& islands,
                                 const Spans& spans, const Context& context);

// Whether an act has such a value, which is written like no name, and what is
// said with it is hardly understood: "if they don't have it, is there a shop
// that sells them" asks for nothing that is called "sells".
bool is_far_fetched(const BuiltAct& act, const Utterance& utterance,
                    const Spans& spans, const Context& context);

// Takes out all islands with such a value.
void leave_out_unknown_values(std::vector<Island>& islands, const Spans& spans);

} // namespace parlour::adapters::nlu
