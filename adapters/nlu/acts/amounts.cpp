#include "adapters/nlu/acts/amounts.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/words.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

namespace {

// What things come in: "two cups of tea".
constexpr std::array<std::string_view, 24> measures{
    "cup",     "cups",     "glass", "glasses", "bottle", "bottles",
    "pot",     "pots",     "piece", "pieces",  "slice",  "slices",
    "portion", "portions", "plate", "plates",  "bowl",   "bowls",
    "pair",    "pairs",    "can",   "cans",    "pint",   "pints"};

// As many as this many tokens make an amount: "two hundred and five".
constexpr std::size_t longest = 5;

bool is_article(std::string_view word) {
  return word == "a" || word == "an" || word == "one";
}

// Reads backwards from the value.
class Reader {
public:
  Reader(const Tokens& tokens, std::size_t position, std::size_t floor)
      : tokens_(tokens), at_(position), floor_(floor) {}

  Amount read() {
    skip_measure();
    Amount amount;
    amount.more = take("more") || take("extra") || take("additional");
    amount.number = number();
    if (amount.number)
      amount.number = number_of_these().value_or(*amount.number);
    if (!amount.number && take("another")) {
      amount.number = 1;
      amount.more = true;
    }
    if (!amount.number && at_ > floor_ && touches() && is_article(before())) {
      amount.number = 1;
      amount.by_article = true;
    }
    return amount;
  }

private:
  const std::string& before() const {
    return tokens_.list[at_ - 1].word;
  }
  // Whether no punctuation is between the word before and what follows.
  bool touches() const {
    return at_ >= tokens_.list.size() ||
           tokens_.list[at_].before == Break::none;
  }

  bool take(std::string_view word) {
    if (at_ <= floor_ || !touches() || before() != word)
      return false;
    --at_;
    return true;
  }

  bool take_determiner() {
    if (at_ <= floor_ || !touches() || !is_determiner(before()))
      return false;
    --at_;
    return true;
  }

  // "cups of", "slices of the"; of "two of my", the number stays.
  void skip_measure() {
    const auto begin = at_;
    take_determiner();
    if (ends_number()) // "a couple of"
      return;
    const bool is_of = take("of") && at_ > floor_ && touches();
    if (is_of && has(measures, before()))
      --at_;
    else if (!is_of || !ends_number())
      at_ = begin;
  }

  bool ends_number() {
    const auto end = at_;
    const bool ends = number().has_value();
    at_ = end;
    return ends;
  }

  // "one of the two …"
  std::optional<std::int64_t> number_of_these() {
    const auto begin = at_;
    if (take_determiner() && take("of"))
      if (const auto some = number())
        return some;
    at_ = begin;
    return {};
  }

  // The longest number that ends here.
  std::optional<std::int64_t> number() {
    for (auto length = std::min(longest, at_ - floor_); length > 0; --length) {
      const auto begin = at_ - length;
      const auto collective = collective_at(tokens_, begin);
      const auto found = collective ? collective : number_at(tokens_, begin);
      if (!touches() || !found || found->ordinal || found->length != length)
        continue;
      at_ = begin;
      return found->value;
    }
    return {};
  }

  const Tokens& tokens_;
  std::size_t at_;
  std::size_t floor_; // at most `at_`
};

} // namespace

Amount amount_before(const Tokens& tokens, std::size_t position,
                     std::size_t floor) {
  return Reader(tokens, position, floor).read();
}

void add_item(Map& slots, const std::string& slot, Map value,
              const Amount& amount) {
  if (amount.number)
    value.set(act_key::amount, *amount.number);
  if (amount.more)
    value.set(act_key::more, true);
  const auto* known = slots.find(slot);
  auto items = known ? *(*known)[act_key::items].if_list() : List();
  items.emplace_back(std::move(value));
  slots.set(slot, Map{{act_key::items, std::move(items)}});
}

} // namespace parlour::adapters::nlu
