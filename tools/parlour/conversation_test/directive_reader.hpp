// DirectiveReader: the words of one line of a conversation file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/value.hpp"

namespace parlour::tools {

struct Word {
  std::string text; // without its quotes
  bool quoted = false;

  // A number, true, false or unknown where it is not quoted; else text.
  Value value() const;
};

class DirectiveReader {
public:
  explicit DirectiveReader(std::string_view text);

  // The next word, quoted with ' or " where it has blanks (a backslash
  // escapes); nothing at the end or where a quote is left open.
  std::optional<Word> word();
  // All that is left, trimmed.
  std::string_view rest() const {
    return rest_;
  }
  bool open_quote() const {
    return open_quote_;
  }

private:
  std::optional<Word> quoted_word(char quote);

  std::string_view rest_;
  bool open_quote_ = false;
};

std::string_view trimmed(std::string_view text);

// The parts before and after the first (or last) " = ", trimmed; nothing where
// there is none.
struct Sides {
  std::string_view left;
  std::string_view right;
};
std::optional<Sides> split_at_first_equals(std::string_view text);
std::optional<Sides> split_at_last_equals(std::string_view text);

} // namespace parlour::tools
