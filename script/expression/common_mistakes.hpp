// Common mistakes: words of other languages and their counterparts here, from
// common_mistakes.def. The table is immutable; safe from any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

class Findings;

enum class MistakePlace : unsigned char {
  operand,
  operation,
  function,
  method,
  element,
  attribute,
};

struct Mistake {
  MistakePlace place;
  std::string_view written; // in small letters
  std::string_view meant;
  std::string_view sentence;
};

// The first row for this place and word, compared without regard to case. With
// `allowed`, a row counts only if its `meant` is in that list or empty. A word
// that is correct already is not a mistake. Null if there is no row. Takes time
// linear in the table.
const Mistake* find_mistake(MistakePlace place, std::string_view written,
                            const std::vector<std::string>* allowed = nullptr);

// Whether further explanations are still worth their time: after a thousand
// findings nobody reads them.
bool explains(const Findings& findings);

} // namespace parlour::script
