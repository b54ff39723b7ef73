// unheard_part: where the robot goes on after it was interrupted (engine rule
// 3.7). A pure function.
#pragma once

#include <string>
#include <string_view>

namespace parlour::dialogue {

// The part of `text` that follows on the words which were heard of it. Case and
// marks of punctuation do not matter. All of it where less than three words
// were heard, or where they are not how the text begins; empty where all of it
// was heard.
std::string unheard_part(std::string_view text, std::string_view heard);

} // namespace parlour::dialogue
