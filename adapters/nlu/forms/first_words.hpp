// Words with which a form may begin. Most words of most sentences are none, and
// trying each reader at each of them would be half of the work of
// understanding.
#pragma once

#include <cstdint>
#include <string_view>

#include "adapters/nlu/forms/normal_forms.hpp"

namespace parlour::adapters::nlu {

// A bit for each form.
using Forms = std::uint8_t;

constexpr Forms forms_bit(Form form) {
  return static_cast<Forms>(1U << static_cast<unsigned>(form));
}

// Those that may begin with the word; an e-mail address may begin with any. A
// reader that accepts another first word must name it here.
Forms forms_from(std::string_view word);

} // namespace parlour::adapters::nlu
