#include "adapters/nlu/grammar/synonyms.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/text/lines.hpp"
#include "adapters/nlu/text/tokens.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// A word may be in several groups.
void add(Automaton::Synonyms& synonyms, WordNumber word) {
  if (std::ranges::find(synonyms, word) == synonyms.end())
    synonyms.push_back(word);
}

} // namespace

std::vector<SynonymGroup> read_synonyms(std::string_view text) {
  std::vector<SynonymGroup> groups;
  for (const auto line : lines_of(text)) {
    SynonymGroup group;
    for (auto& token : tokenize(line).list)
      group.push_back(std::move(token.word));
    if (group.size() > 1)
      groups.push_back(std::move(group));
  }
  return groups;
}

void add_synonyms(const std::vector<SynonymGroup>& groups,
                  const std::function<bool(std::string_view)>& has_meaning,
                  Automaton& automaton) {
  for (const auto& group : groups)
    for (const auto& word : group) {
      if (is_function_word(word) || has_meaning(word))
        continue;
      for (const auto& other : group)
        if (const auto known = automaton.word(other);
            known != unknown_word && other != word)
          add(automaton.synonyms[word], known);
    }
}

} // namespace parlour::adapters::nlu
