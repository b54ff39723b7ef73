#include "adapters/nlu/parse/preferences.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/text/has.hpp"

namespace parlour::adapters::nlu {

namespace {

// If nobody asks for a yes, a topic's own rule for "yes" stands, and "yes" may
// be the value of the slot that was asked for.
bool may_be_yes(const Island& island, const Context& context) {
  return context.confirms.empty() &&
         (!island.rule->bare || (has(island.topics, context.asked_topic) &&
                                 island.find(context.asked_slot) != nullptr));
}

} // namespace

void prefer_answers(std::vector<Island>& islands, const Context& context) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> answers;
  // "Yeah, hi, Ravi Iyer, he's with IT": a yes that passes over more words than
  // it has does not say what they mean.
  for (const auto& island : islands)
    if (island.is_answer() && island.score >= 0)
      answers.emplace_back(island.begin, island.end);
  std::erase_if(islands, [&](const Island& island) {
    return island.is_content() && !may_be_yes(island, context) &&
           std::ranges::any_of(answers, [&](const auto& answer) {
             return answer.first <= island.begin && island.end <= answer.second;
           });
  });
}

namespace {

// An answer with words before the value, "my name is …", that a rule of the
// application takes for another slot of the same topic.
bool says_otherwise(const Island& own, const Island& answer) {
  if (own.rule->generic || own.rule->bare || own.begin > answer.begin ||
      own.end < answer.end ||
      std::ranges::find_first_of(own.topics, answer.topics) == own.topics.end())
    return false;
  return std::ranges::all_of(answer.fills, [&](const Fill& asked) {
    return asked.begin > answer.begin && !own.find(asked.slot) &&
           std::ranges::any_of(own.fills, [&](const Fill& fill) {
             return fill.begin < asked.end && asked.begin < fill.end;
           });
  });
}

} // namespace

void prefer_application(std::vector<Island>& islands) {
  leave_out(islands, [&](const Island& island) {
    return island.rule->generic && island.asked && !island.fills.empty() &&
           std::ranges::any_of(islands, [&](const Island& own) {
             return says_otherwise(own, island);
           });
  });
  // What an application's rule only guesses is no better: in "let me see",
  // nobody is called See.
  struct Own {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    double score = 0;
  };
  std::vector<Own> own;
  for (const auto& island : islands)
    if (!island.rule->generic && !island.rule->bare)
      own.push_back({island.begin, island.end, island.score});
  // A rule of its own that begins with "not" or "leave out" says what that is
  // about.
  const auto begins_own = [&](const Island& island) {
    return std::ranges::any_of(own, [&](const Own& one) {
      return one.begin == island.begin && one.end > island.end;
    });
  };
  std::erase_if(islands, [&](const Island& island) {
    if (!island.rule->generic || island.is_content())
      return false;
    if (island.is_answer())
      return island.denies && begins_own(island);
    return !island.act.empty() && std::ranges::any_of(own, [&](const Own& one) {
      return one.begin == island.begin && one.end == island.end &&
             one.score > 0.5 * island.score;
    });
  });
}

namespace {

// Whether it found a time, a date or the like in its words.
bool has_form(const Island& island, const Spans& spans) {
  return std::ranges::any_of(island.fills, [&](const Fill& fill) {
    return fill.span && is_form(spans[*fill.span].entity);
  });
}

// Whether a rule of the application says it word by word.
bool is_literal(const Island& island) {
  return island.is_content() && !island.rule->generic &&
         !island.fills.empty() &&
         std::ranges::all_of(island.fills, [](const Fill& fill) {
           return fill.literal.has_value();
         });
}

bool shares_topic(const Island& one, const Island& other) {
  return std::ranges::find_first_of(one.topics, other.topics) !=
         one.topics.end();
}

} // namespace

void prefer_literals(std::vector<Island>& islands, const Spans& spans) {
  // Weights are sums of decimals.
  constexpr double rounding = 0.01;
  for (auto& island : islands) {
    if (!is_literal(island))
      continue;
    for (const auto& other : islands)
      if (other.begin == island.begin && other.end == island.end &&
          (other.rule->bare || shares_topic(island, other)) && !other.weak &&
          has_form(other, spans) && other.covered <= island.covered + rounding)
        island.score = std::max(island.score, other.score + rounding);
  }
}

} // namespace parlour::adapters::nlu
