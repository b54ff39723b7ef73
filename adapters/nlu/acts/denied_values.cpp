#include "adapters/nlu/acts/denied_values.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "adapters/nlu/text/negation.hpp"

namespace parlour::adapters::nlu {

namespace {

bool begins_what_is_wanted(std::string_view word) {
  static constexpr std::array<std::string_view, 3> words{"only", "but", "just"};
  return std::ranges::find(words, word) != words.end();
}

} // namespace

bool ends_sentence(const Utterance& utterance, const Island& marker) {
  const auto& tokens = utterance.tokens.list;
  return marker.end < tokens.size() && is_not(tokens[marker.end - 1].word) &&
         tokens[marker.end].before == Break::sentence;
}

bool denies_first_value(const Utterance& utterance, const Island& marker,
                        const Island& island) {
  const auto& tokens = utterance.tokens.list;
  if (marker.denies || marker.end != marker.begin + 1 ||
      tokens[marker.begin].word != "no" || marker.end != island.begin ||
      tokens[island.begin].before != Break::none || island.fills.empty() ||
      island.fills[0].begin != island.begin)
    return false;
  auto at = marker.begin;
  while (at > 0 && tokens[at].before == Break::none && utterance.filler[at - 1])
    --at;
  return at == 0 || tokens[at].before != Break::none;
}

std::uint32_t end_of_denied(const Utterance& utterance, const Island& island) {
  const auto& tokens = utterance.tokens.list;
  for (auto at = island.begin + 1; at < island.end; ++at)
    if (begins_what_is_wanted(tokens[at].word) ||
        (tokens[at].before != Break::none &&
         std::ranges::find(island.fills, at, &Fill::begin) ==
             island.fills.end()))
      return at;
  return island.end;
}

} // namespace parlour::adapters::nlu
