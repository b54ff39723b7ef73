#include "adapters/nlu/understand/learning_words.hpp"

#include <algorithm>
#include <span>

namespace parlour::adapters::nlu {

namespace {

// Whether the span is a known value, without titles and determiners before it.
// Words that only sound or look like one are no evidence: in "how can I root a
// phone", nobody is called Ruth.
bool is_evidence(const Span& span) {
  return has_known_values(span.entity) && !span.weak && !span.unmatched &&
         span.confidence >= guessed_value && span.begin == span.core;
}

} // namespace

std::vector<LearningWord> learning_words(const Utterance& utterance,
                                         const Spans& spans,
                                         const WordVectors* vectors) {
  std::vector<LearningWord> words;
  for (std::size_t at = 0; at < utterance.size(); ++at) {
    const auto& word = utterance.tokens.list[at].word;
    words.push_back({word, 0, vectors ? vectors->find(word) : WordMeaning(),
                     utterance.filler[at]});
  }
  std::vector<const Span*> known;
  for (const auto& span : spans.all())
    if (is_evidence(span))
      known.push_back(&span);
  // Longer values first, so that a value within a longer one does not count.
  std::ranges::stable_sort(known, [](const Span* left, const Span* right) {
    return left->end - left->begin > right->end - right->begin;
  });
  for (const auto* span : known) {
    const auto part =
        std::span(words).subspan(span->begin, span->end - span->begin);
    if (std::ranges::all_of(part,
                            [](const auto& one) { return one.kind == 0; }))
      for (auto& word : part)
        word.kind = span->entity + 1;
  }
  return words;
}

std::string text_of(const std::vector<LearningWord>& words) {
  std::string text;
  for (const auto& word : words)
    if (!word.filler)
      text.append(text.empty() ? "" : " ").append(word.word);
  return text;
}

} // namespace parlour::adapters::nlu
