#include "adapters/asr/moonshine_grammars.hpp"

#include <algorithm>
#include <cctype>

#include "adapters/asr/moonshine_text.hpp"
#include "adapters/asr/words/spoken_words.hpp"

namespace parlour::adapters::moonshine {

namespace {

// To prepare one takes milliseconds.
constexpr std::size_t most_known = 32;
// Of each list of names; the frame has its own bound (moonshine_frames.cpp).
constexpr std::size_t most_values = 2'000;

// As it stands where a sentence begins.
std::string capital(std::string phrase) {
  phrase[0] =
      static_cast<char>(std::toupper(static_cast<unsigned char>(phrase[0])));
  return phrase;
}

// Twice, as the network writes a capital where it thinks that a sentence
// begins.
void add(Words& words, const std::string& phrase) {
  if (phrase.empty())
    return;
  words.phrases.push_back(phrase);
  if (auto first = capital(phrase); first != phrase)
    words.phrases.push_back(std::move(first));
}

Words words_of(const asr::Language::Phrases& phrases) {
  Words words;
  for (const auto& value : phrases.values)
    add(words, value);
  words.names = words.phrases.size();
  for (const auto& word : phrases.words)
    add(words, word);
  return words;
}

} // namespace

// Names that nobody knows are kept, too, so that they are not looked for each
// time.
const MoonshineGrammars::Narrow&
MoonshineGrammars::narrow(const std::vector<std::string>& names) {
  const auto found = std::ranges::find(known_, names, &Narrow::names);
  if (found != known_.end())
    return *found;
  if (known_.size() == most_known)
    known_.erase(known_.begin());
  Narrow made{names, language().sentences(names), {}};
  if (made.graph)
    made.words = words_of(language().phrases(*made.graph, most_values));
  known_.push_back(std::move(made));
  return known_.back();
}

const Words* MoonshineGrammars::words(const std::vector<std::string>& names) {
  const auto& known = narrow(names);
  return known.graph ? &known.words : nullptr;
}

std::optional<bool>
MoonshineGrammars::ends(const std::vector<std::string>& names,
                        const std::string& text) {
  const auto& known = narrow(names);
  return language().ends(known.graph ? *known.graph : language().sentences(),
                         asr::spoken_words(text));
}

std::string MoonshineGrammars::typed(std::string_view text) const {
  return with_capitals(typed_text(text), [this](const std::string& word) {
    return language().written(word);
  });
}

} // namespace parlour::adapters::moonshine
