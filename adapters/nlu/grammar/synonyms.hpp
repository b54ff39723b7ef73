// Synonyms: words that mean the same in everyday talk. Where a grammar has one
// of them, another is understood as well.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/nlu/grammar/automaton.hpp"

namespace parlour::adapters::nlu {

// Words in the form that the tokenizer gives them.
using SynonymGroup = std::vector<std::string>;

// A group a line, words between blanks; "#" begins a comment.
std::vector<SynonymGroup> read_synonyms(std::string_view text);

// Each word of a group may be read as those others of it that the vocabulary
// has. Function words stay what they are, and so do words that `has_meaning`:
// those of names and values.
void add_synonyms(const std::vector<SynonymGroup>& groups,
                  const std::function<bool(std::string_view)>& has_meaning,
                  Automaton& automaton);

} // namespace parlour::adapters::nlu
