#include "adapters/nlu/acts/courtesies.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "adapters/nlu/text/has.hpp"

namespace parlour::adapters::nlu {

namespace {

// "Okay, where is the bank": less than a yes. In "is it open right now", it is
// none at all.
bool is_light_yes(const Utterance& utterance, std::uint32_t begin) {
  const auto sentence =
      stretch_of(utterance.tokens, {begin, begin + 1}, Break::sentence);
  return is_one_of(utterance.tokens.list[begin].word,
                   {"okay", "ok", "right", "alright"}) &&
         utterance.weight_of(sentence.begin, begin) == 0;
}

// Of fewer words, those that join are a part: "And in the bedroom?"
constexpr std::size_t least_sentence = 4;

// The first token behind what joins it to those before: "Also my head is
// splitting".
std::size_t first_of_sentence(const Utterance& utterance) {
  const auto joins = [&](std::size_t token) {
    return utterance.filler[token] ||
           is_one_of(utterance.tokens.list[token].word,
                     {"and", "also", "but", "so", "then", "plus"});
  };
  std::size_t token = 0;
  while (token < utterance.size() && joins(token))
    ++token;
  return token;
}

void leave_out(std::size_t token, Utterance& utterance) {
  utterance.filler[token] = true;
  utterance.weight[token] = 0;
}

} // namespace

bool is_courtesy(std::string_view act) {
  static constexpr std::array<std::string_view, 9> acts{
      "greet",   "thank",    "help", "repeat", "explain",
      "options", "rephrase", "wait", "protest"};
  return has(acts, act);
}

bool is_opening(std::string_view act, std::uint32_t begin,
                const Utterance& utterance, const Context& context) {
  return act == "greet" || act == "thank" ||
         (act == "confirm" && context.confirms.empty() &&
          context.asked_topic == no_topic && is_light_yes(utterance, begin));
}

std::vector<bool> courtesy_tokens(const Chain& chain,
                                  const Utterance& utterance,
                                  const Context& context) {
  std::vector<bool> polite(utterance.size(), false);
  for (const auto& link : chain.links) {
    const auto& island = *link.island;
    if (island.rule->generic && !island.is_content() &&
        (is_courtesy(island.act) ||
         is_opening(island.act, island.begin, utterance, context)))
      for (auto token = island.begin; token < island.end; ++token)
        polite[token] = true;
  }
  return polite;
}

Utterance without_courtesies(Utterance utterance, const Chain& chain,
                             const Context& context) {
  const auto polite = courtesy_tokens(chain, utterance, context);
  for (std::size_t token = 0; token < polite.size(); ++token)
    if (polite[token])
      leave_out(token, utterance);
  const auto sentence = first_of_sentence(utterance);
  if (utterance.size() - sentence >= least_sentence)
    for (std::size_t token = 0; token < sentence; ++token)
      leave_out(token, utterance);
  return utterance;
}

} // namespace parlour::adapters::nlu
