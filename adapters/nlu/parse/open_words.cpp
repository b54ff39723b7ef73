#include "adapters/nlu/parse/open_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// Less than defaults::confirm_below, which is asked back, and less than
// defaults::reject_below.
constexpr double in_doubt = 0.6;
constexpr double not_believed = 0.2;
// A name or a place has no more words.
constexpr std::uint32_t max_words = 5;
// A name in "-ing" is as short as "Ming".
constexpr std::size_t max_short_name = 5;
// Fewer letters are initials, or said by chance.
constexpr std::size_t min_spelt = 3;
// Acts of somebody who does not answer, or not yet.
constexpr std::array<std::string_view, 4> evasions{"wait", "protest", "refuse",
                                                   "explain"};

const Token& token_at(const Utterance& utterance, std::size_t token) {
  return utterance.tokens.list[token];
}

bool is_capital(char letter) {
  return letter >= 'A' && letter <= 'Z';
}

// Whether the writer uses capital letters, beside "I".
bool has_case(const Utterance& utterance) {
  return std::ranges::any_of(utterance.tokens.list, [&](const Token& token) {
    return is_capital(utterance.text[token.begin]) && token.word != "i";
  });
}

// "waiting", "supposed", "exactly"
bool ends_like_no_name(std::string_view word) {
  return word.size() > max_short_name &&
         (word.ends_with("ing") || word.ends_with("ed") ||
          word.ends_with("ly"));
}

// Whether the words tell who somebody is: "I am …".
bool introduces(const Utterance& utterance, TokenRange value) {
  if (value.begin < 2)
    return false;
  const auto& before = token_at(utterance, value.begin - 1).word;
  const auto& who = token_at(utterance, value.begin - 2).word;
  return (before == "am" && who == "i") || (before == "are" && who == "we");
}

bool looks_like_name(const Utterance& utterance, TokenRange value) {
  const auto& first = token_at(utterance, value.begin).word;
  return is_written_as_name(utterance, value) &&
         (!ends_like_no_name(first) ||
          is_capital(utterance.text[token_at(utterance, value.begin).begin]));
}

// Letters are no words: "T H I J S" says no "I".
bool has_sentence_word(const Utterance& utterance, TokenRange range) {
  if (is_spelt(utterance.tokens, range))
    return false;
  for (auto token = range.begin; token < range.end; ++token)
    if (is_sentence_word(token_at(utterance, token).word))
      return true;
  return false;
}

// Whether a word is in no rule, so that it cannot mean something else.
bool has_new_word(const Utterance& utterance, TokenRange range) {
  for (auto token = range.begin; token < range.end; ++token)
    if (!utterance.plain[token])
      return true;
  return false;
}

bool overlap(const Island& left, const Island& right) {
  return left.begin < right.end && right.begin < left.end;
}

// What else an utterance says about its open answers.
class Surroundings {
public:
  Surroundings(const std::vector<Island>& islands, const Utterance& utterance,
               const Spans& spans)
      : islands_(islands), utterance_(utterance), spans_(spans) {
    evades_ = std::ranges::any_of(islands, [](const Island& island) {
      return !island.is_content() &&
             std::ranges::find(evasions, island.act) != evasions.end();
    });
    corrects_ = std::ranges::any_of(islands, &Island::is_marker);
  }

  // "One moment, I have it written down": beside a wish to wait, an answer has
  // a clause of its own and looks like a name. "No, not three, four": beside a
  // correction, words that another slot takes belong to that, and "what am I
  // saying" is no name. "How much is a check-up for a dog" is all of one
  // question.
  bool speak_against(const Island& answer, const Fill& fill) const {
    if (!answer.asked)
      return false;
    if (is_form_of_rule(fill) || ends_other_sentence(answer, fill))
      return true;
    const TokenRange value{fill.begin, fill.end};
    const auto& first = token_at(utterance_, fill.begin).word;
    if (evades_ && (!is_written_as_name(utterance_, value) ||
                    is_determined(answer, fill) || leaves_words(answer)))
      return true;
    return corrects_ &&
           (is_form_elsewhere(fill) ||
            (ends_like_no_name(first) &&
             !is_capital(
                 utterance_.text[token_at(utterance_, fill.begin).begin])));
  }

  // "Hi, Ravi Iyer" gives a name that another slot of the topic has in its
  // list, and no rule says whose; "like this afternoon" is no place
  // "afternoon".
  bool belong_elsewhere(const Island& island, const Fill& fill) const {
    return is_part_of_form(fill) ||
           (says_nothing_else(island, fill) &&
            std::ranges::any_of(islands_, [&](const Island& other) {
              return is_value_of_list(other, fill) &&
                     std::ranges::find_first_of(other.topics, island.topics) !=
                         other.topics.end();
            }));
  }

  // "Good morning, Ravi Iyer" introduces somebody; "good morning, my mobile has
  // no signal" and "hello, parcel for you" do not, though only a greeting
  // stands before what may be a name.
  bool greets_before(const Island& island, const Fill& fill) const {
    if (island.asked || &fill != &island.fills.front() ||
        island.begin == fill.begin || !is_greeted(island, fill))
      return false;
    const TokenRange value{fill.begin, fill.end};
    return is_determined(island, fill) ||
           has_sentence_word(utterance_, value) ||
           !is_written_as_name(utterance_, value);
  }

private:
  // Whether all words before the value are of a greeting, but for a determiner.
  bool is_greeted(const Island& island, const Fill& fill) const {
    bool greeted = false;
    for (auto token = island.begin; token < fill.begin; ++token)
      if (is_of_greeting(token))
        greeted = true;
      else if (!is_determiner(token_at(utterance_, token).word) &&
               !utterance_.filler[token])
        return false;
    return greeted;
  }

  bool is_of_greeting(std::uint32_t token) const {
    return std::ranges::any_of(islands_, [&](const Island& other) {
      return other.act == "greet" && !other.is_content() &&
             other.begin <= token && token < other.end;
    });
  }

  bool is_part_of_form(const Fill& fill) const {
    return std::ranges::any_of(spans_.all(), [&](const Span& span) {
      return is_form(span.entity) && !span.weak && !span.unmatched &&
             span.core <= fill.begin && fill.end <= span.end &&
             fill.end - fill.begin < span.end - span.core;
    });
  }

  // Whether the island's other words are courtesies.
  bool says_nothing_else(const Island& island, const Fill& fill) const {
    if (island.asked || island.begin == fill.begin)
      return false;
    for (auto token = island.begin; token < island.end; ++token)
      if ((token < fill.begin || token >= fill.end) && !is_of_greeting(token))
        return false;
    return true;
  }

  // The whole of a known value, as it is.
  bool is_value_of_list(const Island& other, const Fill& fill) const {
    return other.rule->bare &&
           std::ranges::any_of(other.fills, [&](const Fill& known) {
             return known.slot != fill.slot && known.begin == fill.begin &&
                    known.end == fill.end && known.span &&
                    is_set(spans_[*known.span].entity) &&
                    !spans_[*known.span].unmatched &&
                    spans_[*known.span].values.size() == 1 &&
                    spans_[*known.span].confidence >= 1;
           });
  }

  // "the card", "my phone": the determiner may stand before the value.
  bool is_determined(const Island& answer, const Fill& fill) const {
    return is_determiner(token_at(utterance_, fill.begin).word) ||
           (fill.begin > answer.begin &&
            is_determiner(token_at(utterance_, fill.begin - 1).word));
  }

  // Whether the answer's clause has words that neither it nor anything beside
  // it explains.
  bool leaves_words(const Island& answer) const {
    const auto clause =
        stretch_of(utterance_.tokens, {answer.begin, answer.end}, Break::comma);
    for (auto token = clause.begin; token < clause.end; ++token)
      if (!utterance_.filler[token] && !is_explained(token, answer))
        return true;
    return false;
  }

  bool is_explained(std::uint32_t token, const Island& answer) const {
    const auto holds = [&](const Island& island) {
      return island.begin <= token && token < island.end;
    };
    return holds(answer) ||
           std::ranges::any_of(islands_, [&](const Island& island) {
             return holds(island) && !overlap(island, answer);
           });
  }

  // Whether a sentence of a rule about something else goes on with the answer,
  // which does not look like a name.
  bool ends_other_sentence(const Island& answer, const Fill& fill) const {
    const auto& first = token_at(utterance_, fill.begin);
    return !is_capital(utterance_.text[first.begin]) &&
           std::ranges::any_of(islands_, [&](const Island& other) {
             return is_sentence(other) && goes_on(other.end, answer.begin) &&
                    std::ranges::find_first_of(other.topics, answer.topics) ==
                        other.topics.end();
           });
  }
  // Whether only small words lead from the end of one to the other.
  bool goes_on(std::uint32_t end, std::uint32_t begin) const {
    for (auto token = end; token < begin; ++token)
      if (!utterance_.function[token] ||
          token_at(utterance_, token).before != Break::none)
        return false;
    return end <= begin && token_at(utterance_, begin).before == Break::none;
  }
  static bool is_sentence(const Island& island) {
    return island.is_content() && !island.rule->bare && !island.rule->generic &&
           !island.act.empty();
  }

  bool is_form_elsewhere(const Fill& fill) const {
    return std::ranges::any_of(
        islands_, [&](const Island& island) { return has_form(island, fill); });
  }

  // "Where to?" "At six.": a rule says that it is the time.
  bool is_form_of_rule(const Fill& fill) const {
    return std::ranges::any_of(islands_, [&](const Island& island) {
      return !island.rule->bare && !island.rule->generic &&
             has_form(island, fill);
    });
  }

  // Whether the words of the value are a normal form of another slot.
  bool has_form(const Island& island, const Fill& fill) const {
    return std::ranges::any_of(island.fills, [&](const Fill& other) {
      return other.slot != fill.slot && other.begin <= fill.begin &&
             other.end >= fill.end && other.span &&
             is_form(spans_[*other.span].entity);
    });
  }

  const std::vector<Island>& islands_;
  const Utterance& utterance_;
  const Spans& spans_;
  bool evades_ = false;
  bool corrects_ = false;
};

bool is_said(const Utterance& utterance, TokenRange range) {
  for (auto token = range.begin; token < range.end; ++token)
    if (!utterance.filler[token])
      return true;
  return false;
}

// "Changi Airport, and make that half past four": who is asked answers first.
// What follows in other clauses is something else.
bool says_more(const Utterance& utterance, const OpenWords& words) {
  if (is_said(utterance, {0, words.explained.begin}))
    return true;
  const auto clause = stretch_of(utterance.tokens, words.value, Break::comma);
  return is_said(utterance, {words.explained.end, clause.end});
}

} // namespace

bool is_written_as_name(const Utterance& utterance, TokenRange value) {
  for (auto token = value.begin; token < value.end; ++token)
    if (is_capital(utterance.text[token_at(utterance, token).begin]))
      return true;
  return !has_case(utterance);
}

double certainty_of_words(const Utterance& utterance, const OpenWords& words) {
  const auto value = words.value;
  if (value.begin >= value.end)
    return 1;
  if (introduces(utterance, value) && !looks_like_name(utterance, value))
    return not_believed;
  const bool in_sentence = has_sentence_word(utterance, value);
  if (!words.bare)
    return in_sentence ? in_doubt : 1;
  const bool plausible = is_spelt(utterance.tokens, value) ||
                         (!in_sentence && has_new_word(utterance, value) &&
                          value.end - value.begin <= max_words);
  if (plausible)
    return 1;
  return says_more(utterance, words) ? not_believed : in_doubt;
}

bool may_be_value(const Utterance& utterance, TokenRange value) {
  return certainty_of_words(utterance, {value, value, false}) >= in_doubt;
}

void drop_implausible(std::vector<Island>& islands, const Utterance& utterance,
                      const Spans& spans) {
  const Surroundings surroundings(islands, utterance, spans);
  const auto is_implausible = [&](const Island& island) {
    return std::ranges::any_of(island.fills, [&](const Fill& fill) {
      return is_open(fill, spans) &&
             (surroundings.speak_against(island, fill) ||
              surroundings.belong_elsewhere(island, fill) ||
              surroundings.greets_before(island, fill) ||
              certainty_of_words(utterance, {{fill.begin, fill.end},
                                             {island.begin, island.end},
                                             island.asked}) < in_doubt);
    });
  };
  // They explain words to each other.
  leave_out(islands, is_implausible);
}

bool is_spelt(const Tokens& tokens, TokenRange range) {
  std::size_t letters = 0;
  for (auto token = range.begin; token < range.end; ++token)
    letters += tokens.list[token].word.size() == 1 ? 1U : 0U;
  return letters >= min_spelt && letters == range.end - range.begin;
}

std::string spelt_word(const Tokens& tokens, TokenRange range) {
  std::string word;
  for (auto token = range.begin; token < range.end; ++token)
    word += tokens.list[token].word;
  if (!word.empty() && word[0] >= 'a' && word[0] <= 'z')
    word[0] = static_cast<char>(word[0] - 'a' + 'A');
  return word;
}

} // namespace parlour::adapters::nlu
