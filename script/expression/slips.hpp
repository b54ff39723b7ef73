// Slips: words of other languages and what they are called here, one table
// (slips.def). Immutable; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

class Findings;

enum class SlipPlace : unsigned char {
  operand,
  operation,
  function,
  method,
  element,
  attribute,
};

struct Slip {
  SlipPlace place;
  std::string_view written; // small letters
  std::string_view meant;
  std::string_view sentence;
};

// The first row of that place and word whose meaning is among `allowed`, or
// which has no meaning but a sentence; null where there is none. `allowed`
// null: any.
const Slip* find_slip(SlipPlace place, std::string_view written,
                      const std::vector<std::string>* allowed = nullptr);

// Whether it is still worth looking for nearer words: that takes time, and
// after a thousand findings nobody reads them.
bool explains(const Findings& findings);

} // namespace parlour::script
