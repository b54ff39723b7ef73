#include "adapters/nlu/parse/clause_filters.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "adapters/nlu/parse/question_words.hpp"
#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

class Clauses {
public:
  Clauses(const std::vector<Island>& islands, const Utterance& utterance,
          const Context& context)
      : islands_(islands), utterance_(utterance), question_(utterance, context),
        asks_for_more_(std::ranges::find(context.confirms, "else") !=
                       context.confirms.end()) {}

  // Whoever asks where something stops wants nothing to stop, and "can I leave
  // it with you" breaks off nothing.
  bool is_stop_of_question(const Island& island) const {
    if (!is_generic(island, "cancel"))
      return false;
    const auto first = first_of_clause(island);
    if (first >= island.begin)
      return false;
    if (word(island.begin) == "stop")
      return is_asking_word(word(first));
    if (!is_one_of(word(island.begin), {"leave", "drop"}))
      return false;
    return is_one_of(word(first), {"where", "when", "how"}) ||
           (is_one_of(word(first), {"can", "could", "may", "should"}) &&
            !is_ended_politely(island));
  }

  // "No, wait, it is the eye clinic" says no yes, and "you can ring him" none.
  // Without a no before it, "it is Sunday" stays one: beside a no of another
  // sentence, neither counts.
  bool is_half_a_yes(const Island& island) const {
    if (!is_generic(island, "confirm") || !is_short_sentence(island))
      return false;
    const bool begins = first_of_clause(island) == island.begin;
    if (!follows_marker(island) && (!begins || word(island.begin) == "it"))
      return false;
    const auto clause = clause_of(island);
    for (auto token = clause.begin; token < clause.end; ++token)
      if (utterance_.weight[token] >= full_weight &&
          !is_within(island, token) && !question_.has(token) &&
          !is_said_apart(island, token))
        return true;
    return false;
  }

  // "That's it" is no more where more is asked for, and a yes elsewhere.
  bool is_other_end(const Island& island) const {
    if (word(island.begin) != "that" || island.end < island.begin + 3 ||
        word(island.begin + 1) != "is" ||
        !is_one_of(word(island.begin + 2), {"it", "everything"}))
      return false;
    return asks_for_more_ ? is_generic(island, "confirm")
                          : is_generic(island, "deny");
  }

  // "Which one have I to bring back on Friday?"
  bool is_yes_of_question(const Island& island) const {
    if (!is_generic(island, "confirm"))
      return false;
    const auto first = first_of_clause(island);
    return first < island.begin && word(first) != "why" &&
           is_asking_word(word(first)) &&
           !is_one_of(word(island.begin), {"yes", "yeah", "yep", "sure"});
  }

  // "isn't there a bank?": a question that goes on is none behind a statement.
  bool is_tag_within(const Island& island) const {
    return island.is_tag() && island.end < clause_of(island).end;
  }

  // Who has to go out has not taken leave.
  bool is_bye_within(const Island& island) const {
    return is_generic(island, "bye") && word(island.begin) == "i" &&
           island.end < clause_of(island).end &&
           utterance_.weight[island.end] > 0 &&
           !word(island.end).starts_with("thank");
  }

  // "When does the film start again", "can I start again tomorrow": whoever
  // wants to begin anew says so in a clause that says little else, and only
  // behind it what is wanted then.
  bool is_other_start(const Island& island) const {
    if (!is_generic(island, "restart"))
      return false;
    const auto clause = clause_of(island);
    for (auto token = clause.begin; token < clause.end; ++token)
      if (!is_within(island, token) && !is_said_apart(island, token) &&
          !wishes(token) && !follows(island, token))
        return true;
    return false;
  }

  // "Never mind the dog": what nobody is to mind, unless a rule has these
  // words.
  bool is_never_minded(const Island& island) const {
    const auto clause = clause_of(island);
    auto token = island.begin;
    while (token > clause.begin && is_determiner(word(token - 1)))
      --token;
    if (token > clause.begin && word(token) != "mind")
      --token;
    return island.is_content() && token > clause.begin &&
           word(token) == "mind" && word(token - 1) == "never";
  }

  // "We'll never make that" corrects nothing.
  bool is_marker_within(const Island& island) const {
    if (!island.is_marker() ||
        !is_one_of(word(island.begin), {"make", "change"}))
      return false;
    const auto clause = clause_of(island);
    for (auto token = clause.begin; token < island.begin; ++token)
      if (!wishes(token))
        return true;
    return false;
  }

  // "My phone has no signal" denies nothing.
  bool is_no_within(const Island& island) const {
    return is_generic(island, "deny") && island.end == island.begin + 1 &&
           word(island.begin) == "no" && island.end < clause_of(island).end &&
           island.begin > clause_of(island).begin && !is_before_value(island) &&
           !is_one_of(word(island.end), {"to", "from", "for", "now", "then",
                                         "sorry", "please", "thank"}) &&
           is_one_of(word(island.begin - 1),
                     {"have",  "has",  "had",  "got",  "is",   "are",
                      "was",   "were", "get",  "gets", "with", "there",
                      "in",    "of",   "see",  "find", "know", "need",
                      "makes", "take", "takes"});
  }

private:
  static bool is_generic(const Island& island, std::string_view act) {
    return island.rule->generic && !island.is_content() && island.act == act;
  }
  static bool is_within(const Island& island, std::uint32_t token) {
    return island.begin <= token && token < island.end;
  }

  const std::string& word(std::uint32_t token) const {
    return utterance_.tokens.list[token].word;
  }

  TokenRange clause_of(const Island& island) const {
    return stretch_of(utterance_.tokens, {island.begin, island.end},
                      Break::comma);
  }

  // Behind the words that lead in.
  std::uint32_t first_of_clause(const Island& island) const {
    auto first = clause_of(island).begin;
    while (first < island.begin && leads_in(first))
      ++first;
    return first;
  }

  bool leads_in(std::uint32_t token) const {
    static constexpr std::array<std::string_view, 5> words{"and", "but", "so",
                                                           "then", "now"};
    return utterance_.filler[token] || has(words, word(token));
  }

  // "can we please start again", "start over then"
  bool wishes(std::uint32_t token) const {
    static constexpr std::array<std::string_view, 17> words{
        "i",     "we",   "you",  "us",   "me",     "can",
        "could", "may",  "let",  "will", "should", "would",
        "like",  "want", "need", "have", "to"};
    return leads_in(token) || has(words, word(token));
  }

  // "start over I need a taxi"
  bool follows(const Island& island, std::uint32_t token) const {
    return std::ranges::any_of(islands_, [&](const Island& other) {
      return other.is_content() && !other.rule->bare && !other.act.empty() &&
             other.begin >= island.end && is_within(other, token);
    });
  }

  bool is_short_sentence(const Island& island) const {
    static constexpr std::array<std::string_view, 6> sentences{
        "it is", "i do", "you can", "you may", "do it", "do that"};
    std::string said;
    for (auto token = island.begin; token < island.end; ++token)
      if (!utterance_.filler[token])
        said += (said.empty() ? "" : " ") + word(token);
    return has(sentences, said);
  }

  // "no, it is …", "no, wait, it is …"
  bool follows_marker(const Island& island) const {
    return std::ranges::any_of(islands_, [&](const Island& other) {
      return other.end == island.begin &&
             (other.is_marker() ||
              (is_generic(other, "wait") && follows_marker(other)));
    });
  }

  // "can we leave it for now please"
  bool is_ended_politely(const Island& island) const {
    const auto end = clause_of(island).end;
    for (auto token = island.end; token < end; ++token)
      if (!utterance_.filler[token] &&
          !is_one_of(word(token), {"now", "then", "thanks", "thank", "you",
                                   "for", "the", "moment", "after", "all"}))
        return false;
    return true;
  }

  // "we have no towels"
  bool is_before_value(const Island& island) const {
    return std::ranges::any_of(islands_, [&](const Island& other) {
      return other.begin == island.end && !other.fills.empty();
    });
  }

  // "it is, thank you": another act about the conversation has the word.
  bool is_said_apart(const Island& island, std::uint32_t token) const {
    return std::ranges::any_of(islands_, [&](const Island& other) {
      return other.rule->generic && !other.is_content() && !other.act.empty() &&
             is_within(other, token) &&
             (other.end <= island.begin || island.end <= other.begin);
    });
  }

  const std::vector<Island>& islands_;
  const Utterance& utterance_;
  QuestionWords question_;
  const bool asks_for_more_; // "Anything else?"
};

} // namespace

void leave_out_half_clauses(std::vector<Island>& islands,
                            const Utterance& utterance,
                            const Context& context) {
  const Clauses clauses(islands, utterance, context);
  leave_out(islands, [&](const Island& island) {
    return clauses.is_stop_of_question(island) ||
           clauses.is_half_a_yes(island) ||
           clauses.is_yes_of_question(island) ||
           clauses.is_tag_within(island) || clauses.is_bye_within(island) ||
           clauses.is_other_start(island) || clauses.is_other_end(island) ||
           clauses.is_marker_within(island) || clauses.is_no_within(island) ||
           clauses.is_never_minded(island);
  });
}

namespace {

// What somebody does who only tells or asks: "did you know that I have …".
bool is_telling(std::string_view word) {
  return is_one_of(word, {"say", "tell", "know", "hear", "see", "mention",
                          "happen", "notice", "get", "go"});
}

// What is asked with "did", "why did", but not told with "I did".
bool asks_with_did(const Utterance& utterance, std::uint32_t did) {
  const auto& tokens = utterance.tokens.list;
  return tokens[did].word == "did" &&
         (did == 0 || tokens[did].before != Break::none ||
          utterance.filler[did - 1] || is_asking_word(tokens[did - 1].word)) &&
         !(did + 2 < tokens.size() && is_telling(tokens[did + 2].word));
}

} // namespace

void leave_out_past_orders(std::vector<Island>& islands,
                           const Utterance& utterance, const Schema& schema) {
  const auto says_what = [](const Island& island) {
    return island.is_content() && !island.rule->bare && !island.act.empty();
  };
  const auto is_order = [&](const Island& island) {
    return says_what(island) &&
           std::ranges::none_of(island.topics, [&](TopicNumber topic) {
             return schema.at(topic).enquiry;
           });
  };
  // "did I leave it", "did the light go on": with its subject, or behind it.
  const auto is_past = [&](const Island& island) {
    if (!is_order(island) || island.begin == 0)
      return false;
    if (asks_with_did(utterance, island.begin - 1))
      return island.act == "request";
    return island.begin > 1 && asks_with_did(utterance, island.begin - 2);
  };
  std::vector<TokenRange> past;
  for (const auto& island : islands)
    if (is_past(island))
      past.push_back({island.begin, island.end});
  // Nor is it another order in some of the same words.
  std::erase_if(islands, [&](const Island& island) {
    return says_what(island) &&
           std::ranges::any_of(past, [&](const TokenRange& order) {
             return order.begin <= island.begin && island.begin < order.end;
           });
  });
}

} // namespace parlour::adapters::nlu
