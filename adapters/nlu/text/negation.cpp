#include "adapters/nlu/text/negation.hpp"

#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {

namespace {

using Words = WordSet;

// Words after which "not" negates no order: "I could not find …" still wants
// it, and "did not" reports the past.
const Words& no_orders() {
  static const Words words{"can",  "could", "did", "does", "was", "were",
                           "have", "has",   "had", "why",  "if"};
  return words;
}

// Words that after "not" make a question: "do you not …", "is it not …".
const Words& subjects() {
  static const Words words{"you", "i",    "we",  "there", "it",
                           "he",  "they", "she", "people"};
  return words;
}

// "do not" before one of these is no order: "don't forget to …", "I don't
// mind".
const Words& states_of_mind() {
  static const Words words{
      "know",   "care",     "mind", "forget", "hesitate", "worry", "understand",
      "matter", "remember", "see",  "hear",   "have",     "get",   "got",
      "find",   "only",     "sure", "feel",   "work",     "mean",  "believe"};
  return words;
}

// How something is not to be done: "don't spill it", "don't be late".
const Words& warnings() {
  static const Words words{"laugh", "panic", "hurry", "rush",
                           "argue", "spill", "shout", "fuss"};
  return words;
}
const Words& manners() {
  static const Words words{"late",  "long",   "slow",       "afraid", "shy",
                           "silly", "stupid", "ridiculous", "rude",   "so",
                           "too",   "like",   "such",       "a",      "an"};
  return words;
}

// Who does not do something, unless it is what somebody wants: "you don't
// happen to know …", but "I don't want …" and "you don't have to …".
const Words& wishes() {
  static const Words words{"want",  "need",    "like", "wish",
                           "think", "require", "have"};
  return words;
}

// "No wake-up call then"
constexpr std::size_t longest_refusal = 5;

const Words& settles() {
  static const Words words{"then",     "thanks",  "please", "needed",
                           "required", "anymore", "all"};
  return words;
}

// What follows "never" in a report: "never heard", "never received".
bool is_past(std::string_view word) {
  static const Words words{"heard", "got",  "came", "went", "saw",  "had",
                           "said",  "told", "was",  "were", "been", "found",
                           "knew",  "took", "gave", "met",  "did",  "thought"};
  return word.ends_with("ed") ? word != "need" && word != "feed"
                              : words.contains(word);
}

class Negations {
public:
  explicit Negations(const Tokens& tokens) : tokens_(tokens.list) {}

  // Whether "not" or "never" at this token negates. "you dare" is an exception:
  // "don't you dare open it" is an order.
  bool at(std::size_t token) const {
    if (takes_back(token) || takes_back(token + 1) || forbids(token))
      return true;
    if (!is_not(word(token)))
      return false;
    if (no_orders().contains(word(token - 1)) || word(token + 1) == "mind")
      return false;
    return !subjects().contains(word(token + 1)) || word(token + 2) == "dare";
  }

  // The first word behind the negation that is not a linking word.
  std::string_view object(std::size_t token) const {
    do
      ++token;
    while (is_linking_word(word(token)) && word(token) != "have");
    return word(token);
  }
  // Whether the negation is imperative: "do not", "please not", "must not",
  // "never". "I never heard back" tells something.
  bool is_order(std::size_t token) const {
    const auto before = word(token - 1);
    if (before == "do" && subjects().contains(word(token - 2)) &&
        !wishes().contains(word(token + 1)))
      return false;
    return (word(token) == "never" && !is_past(word(token + 1))) ||
           before == "do" || before == "please" || before == "must" ||
           before == "should";
  }
  bool turns_round(std::size_t token) const {
    if (takes_back(token) || forbids(token))
      return true;
    const auto what = object(token);
    if (warns(token))
      return false;
    return is_order(token) && !what.empty() && !states_of_mind().contains(what);
  }
  // "Don't be late", "don't tell me that …"
  bool warns(std::size_t token) const {
    const auto what = word(token + 1);
    return word(token) == "not" && word(token - 1) == "do" &&
           !subjects().contains(word(token - 2)) &&
           (warnings().contains(what) ||
            (what == "be" && manners().contains(word(token + 2))) ||
            ((what == "tell" || what == "ask") && word(token + 2) == "me"));
  }
  // "… No taxi then.": the last sentence, if it is short and says that
  // something is settled. "No hurry", "no hot water" tell something.
  bool ends_without() const {
    auto first = tokens_.size();
    while (first > 0 && (first == tokens_.size() ||
                         tokens_[first].before != Break::sentence))
      --first;
    const auto length = tokens_.size() - first;
    return word(first) == "no" && length > 2 && length <= longest_refusal &&
           tokens_[first + 1].before == Break::none &&
           settles().contains(tokens_.back().word);
  }

private:
  // "no need to open it", "I forbid you to open it", "stop opening it", "nobody
  // may open it". Not "when do you stop opening it", nor what nobody can do.
  bool forbids(std::size_t token) const {
    static const Words leave{"may", "must", "should", "shall"};
    const auto& here = word(token);
    const auto next = word(token + 1);
    const bool no_need = word(token - 1) == "no" && here == "need";
    const bool stops = here == "stop" || here == "quit";
    return (no_need && next == "to") ||
           (here == "forbid" && word(token - 1) == "i") ||
           (is_no_one(token) && leave.contains(next)) ||
           (begins_order(token) &&
            (here == "avoid" || here == "refuse" ||
             (stops && next.size() > 4 && next.ends_with("ing"))));
  }
  bool is_no_one(std::size_t token) const {
    return word(token) == "nobody" ||
           (word(token) == "one" && word(token - 1) == "no");
  }
  bool begins_order(std::size_t token) const {
    return token == 0 || tokens_[token].before != Break::none ||
           word(token - 1) == "please";
  }
  // "I did not ask you to get it", "nobody told you to". "Did I not ask you to
  // get it?" wants it still.
  bool takes_back(std::size_t token) const {
    static const Words words{"ask",   "asked", "tell",    "told",  "want",
                             "wants", "order", "ordered", "wanted"};
    if (!words.contains(word(token)) || word(token + 1) != "you" ||
        word(token + 2) != "to")
      return false;
    const auto before = word(token - 1);
    if (is_no_one(token - 1))
      return !reproaches(word(token - (before == "one" ? 3 : 2)));
    return (is_not(before) && !subjects().contains(word(token - 2))) ||
           before == "never";
  }
  // "Did nobody tell you to …?"
  static bool reproaches(std::string_view word) {
    return word == "did" || word == "has" || word == "have" || word == "why";
  }

  // Empty before the first token and behind the last one. The index may wrap
  // below 0, which is also behind the last one.
  std::string_view word(std::size_t token) const {
    return token < tokens_.size() ? std::string_view(tokens_[token].word)
                                  : std::string_view();
  }

  const std::vector<Token>& tokens_;
};

} // namespace

std::vector<bool> negations(const Tokens& tokens) {
  const Negations negations(tokens);
  std::vector<bool> found;
  for (std::size_t token = 0; token < tokens.list.size(); ++token)
    found.push_back(negations.at(token));
  return found;
}

bool is_not(std::string_view word) {
  return word == "not" || word == "never";
}

bool is_linking_word(std::string_view word) {
  static const Words words{"want", "need",   "like", "wish", "think",  "to",
                           "ever", "even",   "let",  "dare", "really", "you",
                           "i",    "we",     "us",   "me",   "the",    "a",
                           "an",   "any",    "my",   "your", "have",   "going",
                           "try",  "please", "be"};
  return words.contains(word);
}

bool is_warning(const Tokens& tokens, std::size_t token) {
  return Negations(tokens).warns(token);
}

bool is_negated_order(const Tokens& tokens, const std::vector<bool>& negates) {
  const Negations negations(tokens);
  for (std::size_t token = 0; token < negates.size(); ++token)
    if (negates[token] && negations.turns_round(token))
      return true;
  return negations.ends_without();
}

bool calls_off(const Tokens& tokens) {
  static const Words thoughts{
      "if",  "when", "whether", "until", "unless", "how",   "who", "where",
      "why", "what", "did",     "does",  "may",    "might", "not", "never"};
  // "call that meeting off"
  constexpr std::size_t farthest_off = 3;
  const auto& list = tokens.list;
  const auto ends_clause = [&](std::size_t token) {
    return token + 1 == list.size() || list[token + 1].before != Break::none ||
           list[token + 1].word == "please";
  };
  bool is_thought = false;
  std::size_t call = list.size(); // the last one
  for (std::size_t token = 0; token < list.size(); ++token) {
    const auto& word = list[token].word;
    if (list[token].before == Break::sentence) {
      is_thought = false;
      call = list.size();
    }
    const bool asks_you = word == "do" && token + 1 < list.size() &&
                          list[token + 1].word == "you";
    is_thought = is_thought || asks_you || thoughts.contains(word);
    if (word == "call")
      call = token;
    const bool is_off = word == "off" && call < token &&
                        (token == call + 1 ||
                         (token - call <= farthest_off && ends_clause(token)));
    if (!is_thought && (word == "cancel" || is_off))
      return true;
  }
  return false;
}

} // namespace parlour::adapters::nlu
