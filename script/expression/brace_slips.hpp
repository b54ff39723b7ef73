// What braces in a text that embed nothing were meant to embed (language rules
// 4.4 and 14.3).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "script/expression/expression_slips.hpp"

namespace parlour::script {

// Who is known where the text stands.
struct KnownNames {
  IsDeclared variable;
  IsDeclared function; // besides those that are built in
};

struct BraceSlip {
  std::size_t length = 0; // bytes of the text, with both braces; 1: not closed
  std::string message;    // what to write instead
  // In the place of it all; nothing where no correction is sure.
  std::optional<std::string> replacement{};
};

// Of the brace at `at`, which embeds nothing and is not doubled. Nothing where
// a text in braces was meant: plain words, or what mentions nothing that is
// known. Of what is heard or read by somebody less is taken for such a text.
std::optional<BraceSlip> explain_brace(std::string_view text, std::size_t at,
                                       const KnownNames& known, bool is_heard);

} // namespace parlour::script
