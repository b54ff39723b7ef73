#include "adapters/nlu/parse/unmatched_values.hpp"

#include <algorithm>

#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// How much of what is said with a value that nobody knows must be understood.
constexpr double least_understood = 0.7;

// A longer name of something unknown is none.
constexpr std::uint32_t most_words = 4;
// The share of its words that a value which nobody knows leaves unexplained
// (spans.cpp), and what a word with a meaning is worth, less rounding.
constexpr double unknown_share = 0.3;
constexpr double one_word = 0.9;

// Words that stand in questions and orders of every kind, so they do not tell
// what is wanted of a value. Sorted.
constexpr std::string_view words_of_anything[] = {
    "a",     "about", "all",  "am",     "an",   "and",  "any",   "are",
    "as",    "at",    "be",   "been",   "by",   "can",  "could", "did",
    "do",    "does",  "for",  "from",   "give", "has",  "he",    "her",
    "him",   "his",   "how",  "i",      "if",   "in",   "into",  "is",
    "it",    "just",  "know", "like",   "make", "many", "may",   "me",
    "might", "more",  "most", "much",   "my",   "no",   "not",   "now",
    "of",    "off",   "on",   "one",    "or",   "our",  "out",   "please",
    "say",   "shall", "she",  "should", "show", "so",   "some",  "something",
    "tell",  "that",  "the",  "their",  "them", "then", "they",  "this",
    "to",    "up",    "us",   "was",    "we",   "were", "what",  "which",
    "who",   "will",  "with", "would",  "you",  "your"};

// Words that join parts of a sentence, and are not within a name. Sorted.
constexpr std::string_view joining_words[] = {
    "about", "as", "at", "but",  "by",   "for", "from", "in",
    "on",    "or", "so", "than", "that", "to",  "when", "with"};

// Also where nothing of its kind is expected.
bool is_certain_anywhere(const Span& span) {
  return span.is_certain() && !span.weak;
}

// What is said around an island.
class Surroundings {
public:
  Surroundings(const Utterance& utterance, const Context& context)
      : utterance_(utterance), context_(context) {}

  // Whether the conversation is about it.
  bool is_expected(const Island& island) const {
    return context_.expects_any(island.topics);
  }

  // Whether its clause has words with a meaning that are none of the island.
  bool has_others(const Island& island) const {
    const auto clause = clause_of(island);
    for (auto at = clause.begin; at < clause.end; ++at)
      if ((at < island.begin || at >= island.end) && !utterance_.filler[at] &&
          !utterance_.function[at])
        return true;
    return false;
  }

  TokenRange clause_of(const Island& island) const {
    return stretch_of(utterance_.tokens, {island.begin, island.end},
                      Break::comma);
  }

private:
  const Utterance& utterance_;
  const Context& context_;
};

// Within a text: at its beginning each word has a capital letter.
bool is_capital(const Fill& fill, const Utterance& utterance) {
  const auto first = utterance.text[utterance.tokens.list[fill.begin].begin];
  return fill.begin > 0 && first >= 'A' && first <= 'Z';
}

bool is_unknown_value(const Fill& fill, const Spans& spans) {
  return is_unmatched(fill, spans) && is_set(spans[*fill.span].entity);
}

class Unlikely {
public:
  Unlikely(const Utterance& utterance, const Spans& spans, const Schema& schema,
           const Context& context)
      : utterance_(utterance), spans_(spans), schema_(schema),
        around_(utterance, context) {}

  bool operator()(const Island& island) const {
    if (!has_only_unknown(island) || around_.is_expected(island))
      return false;
    if (any(island, [&](const Fill& fill) {
          return is_no_name(fill) || (fill.end < island.end && is_nobody(fill));
        }))
      return true;
    if (is_whole_clause(island) || any(island, [&](const Fill& fill) {
          return is_capital(fill, utterance_);
        }))
      return false;
    return !is_anchored(island) || around_.has_others(island) ||
           passes_over(island);
  }

private:
  // Whether a value that is said is such.
  template <class Predicate>
  static bool any(const Island& island, Predicate is_such) {
    return std::ranges::any_of(island.fills, [&](const Fill& fill) {
      return !fill.literal && is_such(fill);
    });
  }

  bool has_only_unknown(const Island& island) const {
    const auto is_unknown = [&](const Fill& fill) {
      return is_unknown_value(fill, spans_);
    };
    return any(island, is_unknown) &&
           !any(island, [&](const Fill& fill) { return !is_unknown(fill); });
  }

  const std::string& word(std::uint32_t at) const {
    return utterance_.tokens.list[at].word;
  }

  bool is_no_name(const Fill& fill) const {
    if (fill.end - fill.begin > most_words)
      return true;
    for (auto at = fill.begin; at < fill.end; ++at)
      if (is_sentence_word(word(at)) ||
          std::ranges::binary_search(joining_words, word(at)))
        return true;
    return ends_in_known(fill);
  }

  // "accessible toilet": there are toilets.
  bool ends_in_known(const Fill& fill) const {
    return std::ranges::any_of(spans_.all(), [&](const Span& span) {
      return is_set(span.entity) && is_certain_anywhere(span) &&
             span.core > fill.begin && span.end == fill.end;
    });
  }

  // "does my computer have": people have no determiner. But "call my wife".
  bool is_nobody(const Fill& fill) const {
    return schema_.values().has_people(spans_[*fill.span].entity -
                                       first_set_entity) &&
           fill.begin > 0 && is_determiner(word(fill.begin - 1)) &&
           !is_capital(fill, utterance_);
  }

  bool is_in_fill(const Island& island, std::uint32_t at) const {
    return any(island, [&](const Fill& fill) {
      return fill.begin <= at && at < fill.end;
    });
  }

  // "for the telly" and nothing else.
  bool is_whole_clause(const Island& island) const {
    const auto clause = around_.clause_of(island);
    for (auto at = clause.begin; at < clause.end; ++at)
      if (!is_in_fill(island, at) && !utterance_.filler[at] &&
          !is_determiner(word(at)) &&
          !std::ranges::binary_search(joining_words, word(at)))
        return false;
    return true;
  }

  // Whether the rule has a word that says what is wanted of the value.
  bool is_anchored(const Island& island) const {
    for (auto at = island.begin; at < island.end; ++at)
      if (!is_in_fill(island, at) && !utterance_.filler[at] &&
          !std::ranges::binary_search(words_of_anything, word(at)))
        return true;
    return false;
  }

  // Whether the rule passes over a word with a meaning.
  bool passes_over(const Island& island) const {
    auto unexplained =
        utterance_.weight_of(island.begin, island.end) - island.covered;
    for (const auto& fill : island.fills)
      if (!fill.literal)
        unexplained -=
            unknown_share * utterance_.weight_of(fill.begin, fill.end);
    return unexplained >= one_word;
  }

  const Utterance& utterance_;
  const Spans& spans_;
  const Schema& schema_;
  const Surroundings around_;
};

} // namespace

void leave_out_unlikely_values(std::vector<Island>& islands,
                               const Utterance& utterance, const Spans& spans,
                               const Schema& schema, const Context& context) {
  std::erase_if(islands, Unlikely(utterance, spans, schema, context));
}

void leave_out_lookalikes(std::vector<Island>& islands,
                          const Utterance& utterance, const Spans& spans,
                          const Context& context) {
  const Surroundings around(utterance, context);
  const auto is_guess = [&](const Fill& fill) {
    return fill.span && is_set(spans[*fill.span].entity) &&
           !spans[*fill.span].unmatched &&
           spans[*fill.span].confidence < guessed_value;
  };
  std::erase_if(islands, [&](const Island& island) {
    return island.rule->bare && !island.fills.empty() &&
           std::ranges::all_of(island.fills, is_guess) &&
           !around.is_expected(island) && around.has_others(island);
  });
}

bool is_vague(const Span& span, const Schema& schema) {
  return is_set(span.entity) && !span.unmatched &&
         span.confidence < guessed_value &&
         schema.values().has_things(span.entity - first_set_entity);
}

void leave_out_pieces_of_values(std::vector<Island>& islands,
                                const Spans& spans) {
  const auto is_piece = [&](const Fill& fill) {
    if (!fill.span)
      return false;
    const auto& piece = spans[*fill.span];
    if (!is_set(piece.entity) || piece.unmatched || is_certain_anywhere(piece))
      return false;
    return std::ranges::any_of(spans.all(), [&](const Span& whole) {
      return is_set(whole.entity) && is_certain_anywhere(whole) &&
             whole.core <= piece.core && piece.end <= whole.end &&
             whole.end - whole.core > piece.end - piece.core;
    });
  };
  std::erase_if(islands, [&](const Island& island) {
    return std::ranges::any_of(island.fills, is_piece);
  });
}

void leave_out_rivals_of_answers(std::vector<Island>& islands,
                                 const Spans& spans, const Context& context) {
  if (context.asked_topic == no_topic)
    return;
  std::vector<TokenRange> answers;
  for (const auto& island : islands)
    if (const auto* fill = island.find(context.asked_slot);
        fill && fill->span && spans[*fill->span].is_certain() &&
        has(island.topics, context.asked_topic))
      answers.push_back({fill->begin, fill->end});
  leave_out(islands, [&](const Island& island) {
    return island.is_content() && !context.expects_any(island.topics) &&
           std::ranges::any_of(
               island.fills,
               [&](const Fill& fill) { return is_unmatched(fill, spans); }) &&
           std::ranges::any_of(answers, [&](const TokenRange& answer) {
             return island.begin < answer.end && answer.begin < island.end;
           });
  });
}

bool is_far_fetched(const BuiltAct& act, const Utterance& utterance,
                    const Spans& spans, const Context& context) {
  return act.understood < least_understood &&
         std::ranges::any_of(act.fills, [&](const Fill& fill) {
           return is_unknown_value(fill, spans) &&
                  !is_capital(fill, utterance) &&
                  (act.topic != context.asked_topic ||
                   fill.slot != context.asked_slot);
         });
}

void leave_out_unknown_values(std::vector<Island>& islands,
                              const Spans& spans) {
  std::erase_if(islands, [&](const Island& island) {
    return std::ranges::any_of(island.fills, [&](const Fill& fill) {
      return is_unknown_value(fill, spans);
    });
  });
}

} // namespace parlour::adapters::nlu
