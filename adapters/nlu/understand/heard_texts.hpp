// What else a recogniser may have heard: understood instead of its best text
// only where that makes clearly more sense. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "adapters/nlu/understand/understood.hpp"

namespace parlour::adapters::nlu {

// The first few texts of the context's `heard` that are not this one.
std::vector<std::string> other_texts(const Value& context,
                                     std::string_view text);

// Whether nothing is open in what the best text says: no other is looked at.
// Acts about the conversation (yes, no, cancel) are never looked behind.
bool is_settled(const Understanding& best);

// Whether `other` is understood from its first word to its last, has only
// values that are known, and fits what the conversation is about, where `best`
// is understood in parts or not at all.
bool makes_more_sense(const Understanding& other, const Understanding& best,
                      const Value& context);

// No more certain than what the dialogue asks back about (engine rule 5.5).
void make_doubtful(Understanding& made);

} // namespace parlour::adapters::nlu
