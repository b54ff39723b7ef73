#include "adapters/nlu/parse/mentions.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "adapters/nlu/text/has.hpp"

namespace parlour::adapters::nlu {

namespace {

// What a statement begins with.
constexpr std::array<std::string_view, 12> subjects{
    "i",  "he",  "she",   "we",  "you", "they",
    "my", "our", "their", "his", "her", "the"};

// Who has it, or had.
constexpr std::array<std::string_view, 6> belongings{"was", "were",    "has",
                                                     "had", "belongs", "broke"};

class Mentions {
public:
  Mentions(const std::vector<Island>& islands, const Utterance& utterance)
      : islands_(islands), utterance_(utterance) {}

  bool has(const Island& island) const {
    return is_value(island) && is_in_statement(island) &&
           std::ranges::any_of(islands_, [&](const Island& other) {
             return is_sentence(other) && same_slot(other, island) &&
                    sentence_of(other).begin != sentence_of(island).begin;
           });
  }

private:
  TokenRange sentence_of(const Island& island) const {
    return stretch_of(utterance_.tokens, {island.begin, island.end},
                      Break::sentence);
  }

  static bool is_value(const Island& island) {
    return island.act.empty() && !island.fills.empty();
  }

  static bool same_slot(const Island& one, const Island& other) {
    return one.topics == other.topics &&
           one.fills[0].slot == other.fills[0].slot;
  }

  // Words behind a comma aside: "The blue one, as always."
  bool is_sentence(const Island& island) const {
    const auto begin = sentence_of(island).begin;
    const auto end =
        stretch_of(utterance_.tokens, {island.begin, island.end}, Break::comma)
            .end;
    return is_value(island) && !utterance_.has_content(begin, island.begin) &&
           !utterance_.has_content(island.end, end);
  }

  std::string_view word(std::size_t token) const {
    return token < utterance_.size()
               ? std::string_view(utterance_.tokens.list[token].word)
               : std::string_view();
  }

  // "The red one was my husband's."
  bool is_told_of(const Island& island) const {
    const auto behind = island.end + (word(island.end) == "one" ? 1 : 0);
    return nlu::has(belongings, word(behind)) &&
           utterance_.has_content(island.end, sentence_of(island).end);
  }

  bool is_in_statement(const Island& island) const {
    if (is_told_of(island))
      return true;
    auto begin = sentence_of(island).begin;
    while (begin < island.begin && utterance_.filler[begin])
      ++begin;
    if (!nlu::has(subjects, word(begin)) &&
        !nlu::has(belongings, word(begin + 1)))
      return false;
    for (auto token = begin; token < island.begin; ++token)
      if (utterance_.has_content(token, token + 1) && !is_covered(token))
        return true;
    return false;
  }

  bool is_covered(std::uint32_t token) const {
    return std::ranges::any_of(islands_, [&](const Island& island) {
      return island.score > 0 && island.begin <= token && token < island.end;
    });
  }

  const std::vector<Island>& islands_;
  const Utterance& utterance_;
};

} // namespace

void leave_out_mentions(std::vector<Island>& islands,
                        const Utterance& utterance) {
  const Mentions mentions(islands, utterance);
  leave_out(islands,
            [&](const Island& island) { return mentions.has(island); });
}

} // namespace parlour::adapters::nlu
