#include "adapters/nlu/acts/refusals.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/negation.hpp"

namespace parlour::adapters::nlu {

namespace {

class Refusal {
public:
  Refusal(const BuiltAct& act, const Utterance& utterance)
      : act_(act), utterance_(utterance) {}

  // "Don't spill it", but not "no, don't spill it".
  bool only_warns() const {
    return word(act_.begin) != "no" &&
           is_warning(utterance_.tokens, act_.end - 1);
  }

  // "Heat the hall, and don't you dare open the door": refused is what nobody
  // offers, not what is wanted. "Open the door, no, don't open it" is.
  bool is_of_another(const std::vector<BuiltAct>& acts) const {
    return is_one_of(word(act_.begin), {"do", "never"}) &&
           !is_second_thought() && names_another() &&
           std::ranges::any_of(acts, [&](const BuiltAct& other) {
             return other.topic != no_topic && other.end <= act_.begin;
           });
  }

private:
  const std::string& word(std::size_t token) const {
    return utterance_.tokens.list[token].word;
  }

  // "…, no, don't …"
  bool is_second_thought() const {
    auto token = act_.begin;
    while (token > 0 && utterance_.filler[token - 1] &&
           word(token - 1) != "actually")
      --token;
    return token > 0 &&
           is_one_of(word(token - 1), {"no", "wait", "sorry", "actually"});
  }

  bool names_another() const {
    bool names = false;
    for (auto token = act_.begin; token < act_.end; ++token) {
      if (is_one_of(word(token), {"it", "that", "them", "this", "yet"}))
        return false;
      names |=
          utterance_.has_content(token, token + 1) && !is_said_before(token);
    }
    return names;
  }

  bool is_said_before(std::size_t token) const {
    for (std::size_t at = 0; at < act_.begin; ++at)
      if (word(at) == word(token))
        return true;
    return false;
  }

  const BuiltAct& act_;
  const Utterance& utterance_;
};

} // namespace

bool refuses_nothing(const BuiltAct& act, const std::vector<BuiltAct>& acts,
                     const Utterance& utterance, const Context& context) {
  if (!context.confirms.empty())
    return false;
  const Refusal refusal(act, utterance);
  const bool is_asked =
      context.asked_topic != no_topic || context.waiting_topic != no_topic;
  return refusal.only_warns() || (!is_asked && refusal.is_of_another(acts));
}

} // namespace parlour::adapters::nlu
