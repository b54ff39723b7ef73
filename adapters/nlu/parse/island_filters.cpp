#include "adapters/nlu/parse/island_filters.hpp"

#include <algorithm>
#include <functional>

#include "adapters/nlu/forms/calendar.hpp"
#include "adapters/nlu/parse/clause_filters.hpp"
#include "adapters/nlu/parse/open_words.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// Weights are sums of decimals.
constexpr double rounding = 0.01;

// Whether the value of a fill was found among known ones, with a confidence
// that `is_such` accepts.
template <class Predicate>
bool fits(const Fill& fill, const Spans& spans, Predicate is_such) {
  return fill.span && !is_form(spans[*fill.span].entity) &&
         std::invoke(is_such, spans[*fill.span]);
}

bool is_guess(const Span& span) {
  return !span.unmatched && span.confidence < guessed_value;
}

bool is_one_of_several(const Span& span) {
  return !span.unmatched && span.values.size() > 1;
}

// Whether it says what is wanted, in whatever words but with no value that
// nobody knows.
bool says_what(const Island& island, const Spans& spans) {
  return island.is_content() && !island.rule->bare && !island.act.empty() &&
         std::ranges::none_of(island.fills, [&](const Fill& fill) {
           return fits(fill, spans, &Span::unmatched);
         });
}

// Whether punctuation stands between them.
bool is_apart(const Island& one, const Island& other,
              const Utterance& utterance) {
  const auto first = std::min(one.end, other.end);
  const auto last = std::max(one.begin, other.begin);
  for (auto token = first; token <= last; ++token)
    if (utterance.tokens.list[token].before != Break::none)
      return true;
  return false;
}

} // namespace

void leave_out_guesses(std::vector<Island>& islands, const Spans& spans,
                       const Schema& schema) {
  // "not Palmar, Palmer": what is denied stays, or else the next value would
  // be.
  if (std::ranges::any_of(islands, &Island::denies))
    return;
  struct Sure {
    std::string slot;
    std::uint32_t begin = 0;
  };
  std::vector<Sure> sure;
  for (const auto& island : islands)
    for (const auto& fill : island.fills)
      if (fits(fill, spans, &Span::is_certain) &&
          !fits(fill, spans, is_one_of_several))
        sure.push_back({fill.slot, fill.begin});
  // Of several people, a later word says which; in "Kelvin Palmer, no, Tan", it
  // is somebody else.
  const auto is_outshone = [&](const Fill& fill, const Island& island) {
    return std::ranges::any_of(
               sure,
               [&](const Sure& other) {
                 return other.slot == fill.slot &&
                        (fits(fill, spans, is_guess) ||
                         (fits(fill, spans, is_one_of_several) &&
                          fill.end <= other.begin));
               }) &&
           std::ranges::none_of(island.topics, [&](TopicNumber topic) {
             return schema.at(topic).takes_many(fill.slot);
           });
  };
  std::erase_if(islands, [&](const Island& island) {
    return island.rule->bare && !island.fills.empty() &&
           std::ranges::all_of(island.fills, [&](const Fill& fill) {
             return is_outshone(fill, island);
           });
  });
}

void leave_out_strangers(std::vector<Island>& islands,
                         const Utterance& utterance, const Spans& spans,
                         const Context& context) {
  const auto is_known = [&](const Fill& fill) {
    return fill.literal || fits(fill, spans, &Span::is_certain);
  };
  const auto is_stranger = [&](const Fill& fill) {
    return fits(fill, spans, &Span::unmatched);
  };
  const auto is_better = [&](const Island& island) {
    return std::ranges::any_of(island.fills, is_known);
  };
  const auto is_named = [&](const Fill& fill) {
    return is_written_as_name(utterance, {fill.begin, fill.end});
  };
  // "with clients": of another topic than what is wanted.
  const auto is_foreign = [&](const Island& island, const Island& other) {
    return !other.rule->bare && !other.act.empty() &&
           (other.end <= island.begin || island.end <= other.begin) &&
           std::ranges::find_first_of(island.topics, other.topics) ==
               island.topics.end();
  };
  // While the conversation is about something else.
  const auto is_beside = [&](const Island& island) {
    const bool goes_on = context.asked_topic != no_topic ||
                         context.current != no_topic ||
                         context.completed != no_topic;
    return goes_on && !context.expects_any(island.topics);
  };
  std::vector<const Island*> better;
  for (const auto& island : islands)
    if (is_better(island) || says_what(island, spans))
      better.push_back(&island);
  leave_out(islands, [&](const Island& island) {
    if (std::ranges::none_of(island.fills, is_stranger))
      return false;
    const bool strange = std::ranges::all_of(island.fills, is_stranger);
    const bool nameless = std::ranges::none_of(island.fills, is_named);
    const bool is_story = nameless && (strange || is_beside(island));
    return std::ranges::any_of(better, [&](const Island* other) {
      return (is_story && says_what(*other, spans) &&
              is_before_sentence(island, *other, utterance.tokens)) ||
             (strange && is_better(*other) && island.act.empty() &&
              is_apart(island, *other, utterance)) ||
             (strange && nameless && is_foreign(island, *other) &&
              (!is_apart(island, *other, utterance) ||
               (island.act == "inform" && island.end <= other->begin &&
                is_better(*other) && says_what(*other, spans))));
    });
  });
}

namespace {

// "postponed": a participle, unless it is written as a name or comes after "a".
constexpr std::size_t shortest_participle = 6;

bool names_nothing(const Utterance& utterance, const Fill& fill) {
  const auto& tokens = utterance.tokens.list;
  const auto word = [&](std::uint32_t at) -> const std::string& {
    return tokens[at].word;
  };
  const auto& first = word(fill.begin);
  bool vague = true;
  for (auto at = fill.begin; at < fill.end; ++at)
    vague = vague && (is_vague(word(at)) || utterance.function[at]);
  if (vague || fill.begin == 0)
    return vague;
  const auto& before = word(fill.begin - 1);
  const bool infinitive = before == "to" && fill.begin > 1 &&
                          is_before_infinitive(word(fill.begin - 2));
  const bool participle = first.size() >= shortest_participle &&
                          first.ends_with("ed") && !is_determiner(before) &&
                          utterance.text[tokens[fill.begin].begin] == first[0];
  const bool verb = infinitive || is_before_verb(before);
  return participle || (verb && utterance.plain[fill.begin]);
}

} // namespace

void leave_out_unnamed(std::vector<Island>& islands, const Utterance& utterance,
                       const Spans& spans) {
  std::erase_if(islands, [&](const Island& island) {
    return std::ranges::any_of(island.fills, [&](const Fill& fill) {
      return fits(fill, spans, &Span::unmatched) &&
             names_nothing(utterance, fill);
    });
  });
}

void leave_out_stories(std::vector<Island>& islands, const Utterance& utterance,
                       const Spans& spans, const Context& context) {
  leave_out_half_clauses(islands, utterance, context);
  // "No, B. 2B."
  if (std::ranges::any_of(islands, &Island::is_marker))
    return;
  const auto is_alike = [&](const Fill& fill) {
    return fits(fill, spans, [](const Span& span) {
      return !span.unmatched && span.confidence < 1;
    });
  };
  // The sentences of what is wanted.
  std::vector<TokenRange> wanted;
  for (const auto& island : islands)
    if (says_what(island, spans))
      wanted.push_back(stretch_of(utterance.tokens, {island.begin, island.end},
                                  Break::sentence));
  const auto is_guessed = [&](const Fill& fill) {
    return fits(fill, spans, is_guess);
  };
  const bool asks_for_yes = !context.confirms.empty();
  const auto today = day_of(context.now);
  const auto is_past = [&](const Fill& fill) {
    return today && fill.span &&
           spans[*fill.span].entity == static_cast<EntityId>(Form::date) &&
           spans[*fill.span].value.text() < date_text(*today);
  };
  const auto is_another = [](const Island& island, TokenRange sentence) {
    return island.end <= sentence.begin || sentence.end <= island.begin;
  };
  std::erase_if(islands, [&](const Island& island) {
    if (island.act.empty() && !island.fills.empty() &&
        !context.expects_any(island.topics) &&
        std::ranges::all_of(island.fills, is_past))
      return std::ranges::any_of(wanted, [&](TokenRange sentence) {
        return is_another(island, sentence);
      });
    if (!island.rule->bare || island.fills.empty() ||
        context.expects_any(island.topics) ||
        !std::ranges::all_of(island.fills, is_alike))
      return false;
    const bool guess = std::ranges::all_of(island.fills, is_guessed);
    return (guess && asks_for_yes) ||
           std::ranges::any_of(wanted, [&](TokenRange sentence) {
             return guess || is_another(island, sentence);
           });
  });
}

// At its beginning it may be one: "wait, where is the bank", and where the rule
// takes any words, these may be the act's.
void leave_out_acts_inside(std::vector<Island>& islands,
                           const Utterance& utterance, const Spans& spans) {
  const auto says_it_itself = [&](const Island& island) {
    return island.is_content() && !island.weak && !island.rule->bare &&
           island.covered + rounding >
               utterance.weight_of(island.begin, island.end) &&
           std::ranges::none_of(island.fills, [&](const Fill& fill) {
             return fill.open || fits(fill, spans, &Span::unmatched);
           });
  };
  struct Said {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    double score = 0;
  };
  std::vector<Said> said;
  for (const auto& island : islands)
    if (says_it_itself(island))
      said.push_back({island.begin, island.end, island.score});
  std::erase_if(islands, [&](const Island& island) {
    const bool is_act = !island.is_content() && !island.act.empty() &&
                        !island.is_marker() && island.act != "confirm";
    return is_act && std::ranges::any_of(said, [&](const Said& more) {
             return more.begin < island.begin && island.end <= more.end &&
                    island.score <= more.score;
           });
  });
}

void trust_whole_values(std::vector<Island>& islands,
                        const Utterance& utterance, const Spans& spans) {
  const auto is_whole = [&](const Island& island) {
    for (std::size_t token = 0; token < utterance.size(); ++token)
      if (!utterance.filler[token] &&
          (token < island.begin || token >= island.end))
        return false;
    return true;
  };
  const auto is_sure = [](const Span& span) {
    return !span.unmatched && span.confidence >= guessed_value;
  };
  for (auto& island : islands)
    if (island.weak && island.rule->bare && !island.fills.empty() &&
        is_whole(island) &&
        std::ranges::all_of(island.fills, [&](const Fill& fill) {
          return fits(fill, spans, is_sure);
        }))
      island.weak = false;
}

void leave_out_parts(std::vector<Island>& islands, const Schema& schema,
                     const Context& context) {
  leave_out_topics(islands, [&](const Island&, TopicNumber topic) {
    return schema.at(topic).part && !context.goes_on(topic);
  });
}

} // namespace parlour::adapters::nlu
