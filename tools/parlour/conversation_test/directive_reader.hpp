// DirectiveReader: splits one line of a conversation file into words. Pure;
// refers to the text, which must outlive it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/value.hpp"

namespace parlour::tools {

// A word of a line.
struct Word {
  std::string text; // without quotes and backslashes
  bool quoted = false;

  // The word as a value: a number, true, false or unknown if it is not quoted;
  // otherwise text.
  Value value() const;
};

// The word as it is written in a line, so that the reader gives this value
// again; nothing for a list, a map or anything else that no word can be.
std::optional<std::string> written(const Value& value);

class DirectiveReader {
public:
  explicit DirectiveReader(std::string_view text);

  // The next word. It may be quoted with ' or ", and then contain blanks and
  // characters escaped with a backslash. Nothing at the end of the line, or if
  // a quote is not closed (see open_quote).
  std::optional<Word> word();
  // The rest of the line, without blanks around it.
  std::string_view rest() const {
    return rest_;
  }
  // Whether a quote was opened and not closed.
  bool open_quote() const {
    return open_quote_;
  }

private:
  std::optional<Word> quoted_word(char quote);

  std::string_view rest_;
  bool open_quote_ = false;
};

// The text without blanks around it.
std::string_view trimmed(std::string_view text);

// The parts before and after " = ", without blanks around them; nothing if the
// text has no " = ". A slot's value may contain one, and so may a query: they
// are split at the first and the last one.
struct Sides {
  std::string_view left;
  std::string_view right;
};
std::optional<Sides> split_at_first_equals(std::string_view text);
std::optional<Sides> split_at_last_equals(std::string_view text);

} // namespace parlour::tools
