#include "adapters/nlu/acts/courtesies.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "adapters/nlu/text/has.hpp"

namespace parlour::adapters::nlu {

namespace {

bool begins_sentence(const Island& island, const Utterance& utterance) {
  return utterance.weight_of(stretch_of(utterance.tokens,
                                        {island.begin, island.end},
                                        Break::sentence)
                                 .begin,
                             island.begin) == 0;
}

} // namespace

bool is_courtesy(std::string_view act) {
  static constexpr std::array<std::string_view, 9> acts{
      "greet",   "thank",    "help", "repeat", "explain",
      "options", "rephrase", "wait", "protest"};
  return has(acts, act);
}

bool is_opening(std::string_view act, const Context& context) {
  return act == "greet" || act == "thank" ||
         (act == "confirm" && context.confirms.empty() &&
          context.asked_topic == no_topic);
}

std::vector<bool> courtesy_tokens(const Chain& chain,
                                  const Utterance& utterance,
                                  const Context& context) {
  std::vector<bool> polite(utterance.size(), false);
  for (const auto& link : chain.links) {
    const auto& island = *link.island;
    const bool opens =
        is_opening(island.act, context) &&
        (island.act != "confirm" || begins_sentence(island, utterance));
    if (island.rule->generic && !island.is_content() &&
        (opens || is_courtesy(island.act)))
      for (auto token = island.begin; token < island.end; ++token)
        polite[token] = true;
  }
  return polite;
}

Utterance without_courtesies(Utterance utterance, const Chain& chain,
                             const Context& context) {
  const auto polite = courtesy_tokens(chain, utterance, context);
  for (std::size_t token = 0; token < polite.size(); ++token)
    if (polite[token]) {
      utterance.filler[token] = true;
      utterance.weight[token] = 0;
    }
  return utterance;
}

} // namespace parlour::adapters::nlu
