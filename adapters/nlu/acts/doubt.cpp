#include "adapters/nlu/acts/doubt.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "adapters/nlu/acts/courtesies.hpp"
#include "adapters/nlu/acts/other_terms.hpp"
#include "adapters/nlu/acts/refusals.hpp"
#include "adapters/nlu/parse/question_words.hpp"
#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/negation.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// Acts that ask something back: whoever asks has not answered yet.
constexpr std::array<std::string_view, 5> questions{"help", "repeat", "explain",
                                                    "options", "rephrase"};
// Acts beside which a yes is none, but a no is.
constexpr std::array<std::string_view, 2> hesitations{"wait", "refuse"};

// A weight below this is rounding, not a word.
constexpr double min_weight = 0.05;
// How many small words may be left over beside a yes.
constexpr std::size_t most_small = 2;

bool is_pronoun(std::string_view word) {
  static constexpr std::array<std::string_view, 6> words{"i",  "you",  "it",
                                                         "we", "that", "this"};
  return has(words, word);
}

// Small words that change nothing about a yes before them: "yes I will", "yes
// now". The other way round it is a question: "yes will I".
bool is_harmless(std::string_view word, std::string_view before) {
  static constexpr std::array<std::string_view, 12> verbs{
      "am",    "is",  "are",   "do",  "does",  "will",
      "would", "can", "could", "may", "shall", "have"};
  static constexpr std::array<std::string_view, 5> others{
      "very", "really", "already", "now", "then"};
  return is_pronoun(word) || has(others, word) ||
         (is_pronoun(before) && has(verbs, word));
}

// Whether the act is this generic act, about no topic.
bool is_plain(const BuiltAct& act, std::string_view name) {
  return act.topic == no_topic && act.act == name;
}

bool is_answer(const BuiltAct& act) {
  return is_plain(act, "confirm") || is_plain(act, "deny");
}

// Applies the rules to the acts of one utterance.
class Doubts {
public:
  Doubts(std::vector<BuiltAct>& acts, const Chain& chain,
         const Utterance& utterance, const Context& context)
      : acts_(acts), utterance_(utterance), context_(context),
        question_(utterance, context), understood_(utterance.size(), false) {
    for (std::size_t at = 0; at < chain.links.size(); ++at)
      note(chain, at);
  }

  // The order matters: each step removes acts that the next ones would count.
  void run() {
    // "Okay, never open the door" says no yes.
    if (any("deny"))
      std::erase_if(acts_, [&](auto& act) {
        return is_plain(act, "confirm") &&
               is_opening(act.act, act.begin, utterance_, context_);
      });
    std::erase_if(acts_, [&](auto& act) { return is_trailing(act); });
    if (std::erase_if(acts_, [&](auto& act) { return takes_back(act); }) > 0)
      std::erase_if(acts_, [](auto& act) { return is_plain(act, "confirm"); });
    if (std::erase_if(acts_, [&](auto& act) { return is_denied(act); }) > 0)
      std::erase_if(acts_, [](auto& act) { return is_plain(act, "deny"); });
    if (any("confirm"))
      std::erase_if(acts_, [&](auto& act) { return repeats_question(act); });
    const bool contradicts = any("confirm") && (any("deny") || any("correct"));
    const bool asks = std::ranges::any_of(acts_, [](auto& act) {
      return act.topic == no_topic && has(questions, act.act);
    });
    leave_out_yes_on_other_terms();
    if (contradicts || asks)
      std::erase_if(acts_, [](auto& act) { return is_answer(act); });
    if (std::ranges::any_of(acts_, [&](auto& act) { return hinders(act); }))
      std::erase_if(acts_, [](auto& act) { return is_plain(act, "confirm"); });
    std::erase_if(acts_, [&](auto& act) { return is_unsure(act); });
  }

private:
  // Whether a yes beside it is none. A cancel is for the dialogue where it
  // asks.
  bool hinders(const BuiltAct& act) const {
    return act.topic == no_topic &&
           (has(hesitations, act.act) ||
            (context_.confirms.empty() &&
             (act.act == "cancel" || act.act == "abandon")));
  }

  // Notes which tokens an island has understood. An answer that skips words has
  // not understood them. Words that lead in ("and") are understood if content
  // follows.
  void note(const Chain& chain, std::size_t at) {
    const auto& island = *chain.links[at].island;
    if (island.is_tag()) {
      tags_.push_back({island.begin, island.end});
      std::fill(understood_.begin() + island.begin,
                understood_.begin() + island.end, true);
      return;
    }
    const bool leads_in = !island.is_content() && island.act.empty();
    const bool leads_nowhere =
        leads_in && (at + 1 == chain.links.size() ||
                     !chain.links[at + 1].island->is_content());
    if (leads_nowhere || (island.is_answer() && passes_over(island)))
      return;
    for (auto token = island.begin; token < island.end; ++token)
      understood_[token] = !leads_in || !is_turning_word(word(token));
    if (island.denies)
      denials_.push_back(island.begin);
  }

  bool passes_over(const Island& island) const {
    return island.covered + min_weight <
           utterance_.weight_of(island.begin, island.end);
  }

  const std::string& word(std::size_t token) const {
    return utterance_.tokens.list[token].word;
  }

  bool any(std::string_view name) const {
    return std::ranges::any_of(acts_,
                               [&](auto& act) { return is_plain(act, name); });
  }

  bool repeats_question(const BuiltAct& act) const {
    return !is_answer(act) && act.act != "correct" && act.act != "wait" &&
           question_.has_all_of(act);
  }

  // "Did you say blue?" "Yes, blue, don't book it.": the value of the question,
  // with a negation anywhere in the utterance.
  bool takes_back(const BuiltAct& act) const {
    return !context_.confirms.empty() && act.topic != no_topic &&
           act.act != "deny" && !act.fills.empty() &&
           (any("deny") || has(utterance_.negates, true)) &&
           std::ranges::all_of(act.fills, [&](const Fill& fill) {
             return is_of_question(fill);
           });
  }

  bool is_of_question(const Fill& fill) const {
    for (auto token = fill.begin; token < fill.end; ++token)
      if (!has(context_.confirms, word(token)))
        return false;
    return true;
  }

  // "Where is the bank, ok?", "is it open, not today?": an answer behind a
  // question of the same sentence only asks for one. Without a question mark,
  // "ok" and "right" do so, too.
  bool is_trailing(const BuiltAct& act) const {
    if (!is_answer(act) || act.negated || (!is_asked(act) && !is_nod(act)))
      return false;
    const auto sentence =
        stretch_of(utterance_.tokens, {act.begin, act.end}, Break::sentence);
    return utterance_.weight_of(act.end, sentence.end) < min_weight &&
           std::ranges::any_of(acts_, [&](auto& other) {
             return other.topic != no_topic && other.act == "request" &&
                    sentence.begin < other.end && other.end <= act.begin;
           });
  }

  // A time begins nothing of its own then.
  void leave_out_yes_on_other_terms() {
    const auto yes = std::ranges::find(acts_, "confirm", &BuiltAct::act);
    if (yes == acts_.end() || yes->topic != no_topic || is_suggestion(*yes))
      return;
    if (const auto terms = other_terms(utterance_, acts_, *yes, context_))
      std::erase_if(acts_, [&](auto& act) {
        return is_plain(act, "confirm") ||
               (act.elliptical && act.begin < terms->end &&
                terms->begin < act.end);
      });
  }

  // "Okay, who is it?" only begins what is about something else.
  bool opens_other(const BuiltAct& act) const {
    const bool waits_for_value =
        context_.asked_topic != no_topic && context_.confirms.empty();
    if (waits_for_value || !is_nod(act))
      return false;
    const auto sentence =
        stretch_of(utterance_.tokens, {act.begin, act.end}, Break::sentence);
    return std::ranges::any_of(acts_, [&](auto& other) {
      const bool is_other =
          other.topic == no_topic
              ? other.act == "greet"
              : !other.elliptical && !context_.goes_on(other.topic);
      return is_other && act.end <= other.begin && other.begin < sentence.end;
    });
  }

  bool is_nod(const BuiltAct& act) const {
    static constexpr std::array<std::string_view, 6> words{
        "ok", "okay", "right", "alright", "all", "fine"};
    for (auto token = act.begin; token < act.end; ++token)
      if (!has(words, word(token)))
        return false;
    return true;
  }

  // "do not cancel it", "no need to cancel": a generic act right behind a
  // negation, or behind a no that ends with "to".
  bool is_denied(const BuiltAct& act) const {
    if (act.topic != no_topic || is_answer(act) || act.act == "correct")
      return false;
    if (act.begin > 0 && word(act.begin - 1) == "to" &&
        std::ranges::any_of(acts_, [&](auto& other) {
          return is_plain(other, "deny") && other.end == act.begin;
        }))
      return true;
    auto at = act.begin;
    while (at > 0 && utterance_.filler[at - 1])
      --at;
    return at > 0 && is_not(word(at - 1));
  }

  // "Cancel the six o'clock alarm" is about the application, whether or not it
  // knows such an order. To stop is always understood. Another clause is
  // about something else: "never mind, I can walk".
  bool leaves_known_words(const BuiltAct& act) const {
    const auto clause =
        stretch_of(utterance_.tokens, {act.begin, act.begin + 1}, Break::comma);
    for (auto token = clause.begin; token < clause.end; ++token)
      if (!understood_[token] && utterance_.weight[token] >= full_weight &&
          utterance_.words[token] != unknown_word &&
          !has(context_.confirms, word(token)))
        return true;
    return false;
  }

  // A yes is in doubt if words are left over or it is asked ("right?"). A no is
  // a safer reading, so it is in doubt only if it is a bare "not" with words
  // left over ("not bad").
  bool is_unsure(const BuiltAct& act) const {
    if (is_plain(act, "help"))
      return knows_nobody(act);
    if (is_plain(act, "confirm"))
      return is_right_now(act) || opens_other(act) || leaves_words(act.begin) ||
             (is_asked(act) && !answers_by_asking(act)) || is_suggestion(act) ||
             is_turned_round(act) || is_before_tag(act);
    if (is_plain(act, "cancel") || is_plain(act, "abandon"))
      return word(act.begin) != "stop" && leaves_known_words(act);
    return is_plain(act, "deny") && !act.negated &&
           (refuses_nothing(act, acts_, utterance_, context_) ||
            (has(denials_, act.begin) && leaves_words(utterance_.size())));
  }

  // "I don't know him" asks for no help.
  bool knows_nobody(const BuiltAct& act) const {
    static constexpr std::array<std::string_view, 6> people{
        "him", "her", "them", "you", "anybody", "anyone"};
    return word(act.end - 1) == "know" && act.end < utterance_.size() &&
           has(people, word(act.end));
  }

  // Whether words are left that nothing has understood. Fillers and the words
  // of the question do not count, but words such as "but" always do.
  // Neither do a few small words behind `yes`, the token of the yes, nor those
  // of sentences behind that which begins with it: "Yes please. And where …"
  bool leaves_words(std::size_t yes) const {
    std::size_t small = 0;
    const auto end = end_of_first_sentence(yes);
    for (std::size_t token = 0; token < utterance_.size(); ++token) {
      if (understood_[token])
        continue;
      const bool turns = is_turning_word(word(token)) ||
                         (token < end && is_asking_word(word(token)));
      const bool means_nothing = utterance_.weight[token] < min_weight ||
                                 question_.has(token) || token >= end;
      if (turns || (!means_nothing && !may_follow(token, yes)))
        return true;
      small += means_nothing ? 0U : 1U;
    }
    return small > most_small;
  }

  // The end of all if the token stands in another one, or if no yes is asked
  // for.
  std::size_t end_of_first_sentence(std::size_t token) const {
    if (token >= utterance_.size() || context_.confirms.empty())
      return utterance_.size();
    const auto at = static_cast<std::uint32_t>(token);
    const auto sentence =
        stretch_of(utterance_.tokens, {at, at + 1}, Break::sentence);
    return sentence.begin == 0 ? sentence.end : utterance_.size();
  }

  // "of course you can't", "yes I can not": a negation beside the yes, even one
  // that some rule has understood. Nor does a yes stand where another topic
  // wants no such thing: "yes, no call at all".
  bool is_turned_round(const BuiltAct& act) const {
    for (std::size_t token = 0; token < utterance_.size(); ++token) {
      const bool is_within = token >= act.begin && token < act.end;
      if (!is_within && !is_of_tag(token) &&
          (is_not(word(token)) || (word(token) == "no" && is_of_topic(token))))
        return true;
    }
    return false;
  }

  // "That is what I said, isn't it? Yes!"
  bool is_of_tag(std::size_t token) const {
    return std::ranges::any_of(tags_, [&](const TokenRange& tag) {
      return tag.begin <= token && token < tag.end;
    });
  }

  // "Yes or not?", "yes, is that right?"
  bool is_before_tag(const BuiltAct& act) const {
    return std::ranges::any_of(
        tags_, [&](const TokenRange& tag) { return act.begin < tag.begin; });
  }

  bool is_of_topic(std::size_t token) const {
    return std::ranges::any_of(acts_, [&](auto& act) {
      return act.topic != no_topic && act.begin <= token && token < act.end;
    });
  }

  bool may_follow(std::size_t token, std::size_t yes) const {
    return token > yes && is_harmless(word(token), word(token - 1));
  }

  // "is it open right now"
  bool is_right_now(const BuiltAct& act) const {
    static constexpr std::array<std::string_view, 4> behind{"now", "away",
                                                            "here", "then"};
    return act.end == act.begin + 1 && word(act.begin) == "right" &&
           act.end < utterance_.size() && has(behind, word(act.end));
  }

  bool asks_why_not(const BuiltAct& act) const {
    for (auto token = act.begin; token < act.end; ++token)
      if (word(token) == "why")
        return true;
    return false;
  }

  // Where yes or no is asked for, it is a yes.
  bool answers_by_asking(const BuiltAct& act) const {
    return !context_.confirms.empty() && asks_why_not(act);
  }

  // "Why not tomorrow?"
  bool is_suggestion(const BuiltAct& act) const {
    const auto clause =
        stretch_of(utterance_.tokens, {act.begin, act.end}, Break::comma);
    return asks_why_not(act) && std::ranges::any_of(acts_, [&](auto& other) {
             return other.topic != no_topic && act.end <= other.begin &&
                    other.begin < clause.end;
           });
  }

  // Whether a question mark follows the act.
  bool is_asked(const BuiltAct& act) const {
    const auto& tokens = utterance_.tokens.list;
    const auto from = tokens[act.end - 1].end;
    const auto to = act.end < tokens.size() ? tokens[act.end].begin
                                            : utterance_.text.size();
    return utterance_.text.substr(from, to - from).find('?') !=
           std::string_view::npos;
  }

  std::vector<BuiltAct>& acts_;
  const Utterance& utterance_;
  const Context& context_;
  QuestionWords question_;
  // By token.
  std::vector<bool> understood_;
  // The tokens at which a "not" begins.
  std::vector<std::uint32_t> denials_;
  std::vector<TokenRange> tags_;
};

} // namespace

void drop_doubtful(std::vector<BuiltAct>& acts, const Chain& chain,
                   const Utterance& utterance, const Context& context) {
  Doubts(acts, chain, utterance, context).run();
}

} // namespace parlour::adapters::nlu
