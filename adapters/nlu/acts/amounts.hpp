// Amounts: how many of a value are meant, by the words before it: "two
// coffees", "another tea", "a couple of cups of tea". Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "adapters/nlu/text/tokens.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters::nlu {

struct Amount {
  std::optional<std::int64_t> number; // none: not said
  bool more = false;                  // so many in addition
  bool by_article = false;            // "a coffee"
};

// Before the value that begins at the token `position`. What stands before the
// token `floor` is said of something else: "room 204 coffee".
Amount amount_before(const Tokens& tokens, std::size_t position,
                     std::size_t floor = 0);

// One more of several values of a slot, as an act has them (act_key::items).
void add_item(Map& slots, const std::string& slot, Map value,
              const Amount& amount);

} // namespace parlour::adapters::nlu
