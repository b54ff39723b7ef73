// The tokenizer reads characters and decides for each whether it belongs to the
// current word. Punctuation inside of numbers, abbreviations and e-mail
// addresses does.
#include "adapters/nlu/text/tokens.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "adapters/nlu/text/characters.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t usual_bytes_per_word = 4;

bool is_digit(char32_t code) {
  return code >= '0' && code <= '9';
}

// Typewriter and typographic apostrophes.
bool is_apostrophe(char32_t code) {
  return code == '\'' || code == 0x2019 || code == 0x2018 || code == '`';
}

bool is_email_character(char32_t code) {
  return is_word_character(code) || code == '.' || code == '_' || code == '-' ||
         code == '+' || code == '@' || code == '%';
}

// What a character between words separates. 0x2013 and 0x2014 are dashes,
// 0x2026 is an ellipsis.
Break break_of(char32_t code) {
  switch (code) {
  case ',':
  case ';':
  case ':':
  case '(':
  case ')':
  case 0x2013:
  case 0x2014:
    return Break::comma;
  case '.':
  case '?':
  case '!':
  case '\n':
  case 0x2026:
    return Break::sentence;
  default:
    return Break::none;
  }
}

// Reads the text from left to right, one word at a time.
class Tokenizer {
public:
  explicit Tokenizer(std::string_view text)
      : text_(text), has_email_(text.find('@') != std::string_view::npos) {
    tokens_.list.reserve(
        std::min(text.size() / usual_bytes_per_word + 2, max_tokens));
  }

  Tokens run() {
    while (skip_to_word()) {
      if (tokens_.list.size() >= max_tokens) {
        tokens_.truncated = true;
        break;
      }
      take_word();
    }
    return std::move(tokens_);
  }

private:
  // The character `ahead` bytes after the position, 0 past the end.
  char32_t peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? character_at(text_, at_ + ahead).code
                                      : 0;
  }

  // A telephone number may begin with "+".
  bool starts_word() const {
    return is_word_character(peek()) || (peek() == '+' && is_digit(peek(1)));
  }

  // Moves to the next word and notes the strongest break on the way. False at
  // the end of the text.
  bool skip_to_word() {
    break_ = Break::none;
    while (at_ < text_.size() && !starts_word()) {
      const auto character = character_at(text_, at_);
      note_break(break_of(character.code));
      at_ += character.length;
    }
    return at_ < text_.size();
  }

  // A full stop after a title or an initial ends no sentence: "Dr. Ho".
  void note_break(Break found) {
    if (found == Break::sentence && !tokens_.list.empty()) {
      const auto& last = tokens_.list.back();
      if (text_[at_] == '.' && last.end == at_ &&
          (is_title(last.word) || last.word.size() == 1))
        return;
    }
    break_ = std::max(break_, found);
  }

  void take_word() {
    begin_ = at_;
    raw_.clear();
    if (const auto length = has_email_ ? email_length() : 0; length > 0)
      take_bytes(length);
    else
      take_characters();
    push();
  }

  // The length of the e-mail address that begins here, or 0. It must have an
  // "@" with characters on both sides; punctuation at its end does not belong
  // to it.
  std::size_t email_length() const {
    auto end = at_;
    auto sign = std::string_view::npos;
    while (end < text_.size() && end - at_ <= max_word_bytes) {
      const auto character = character_at(text_, end);
      if (!is_email_character(character.code))
        break;
      if (character.code == '@')
        sign = end;
      end += character.length;
    }
    while (end > at_ && !is_word_character(character_at(text_, end - 1).code))
      --end;
    const bool whole =
        sign != std::string_view::npos && sign > at_ && end > sign + 1;
    return whole ? end - at_ : 0;
  }

  void take_bytes(std::size_t length) {
    const auto end = at_ + length;
    while (at_ < end) {
      const auto character = character_at(text_, at_);
      append_folded(raw_, character.code);
      at_ += character.length;
    }
  }

  // `previous_` is the character before the current one inside of the same
  // word.
  void take_characters() {
    previous_ = 0;
    while (at_ < text_.size()) {
      const auto character = character_at(text_, at_);
      if (is_word_character(character.code))
        append(character.code);
      else if (!joins(character))
        break;
      previous_ = character.code;
      at_ += character.length;
    }
  }

  void append(char32_t code) {
    if (raw_.size() < max_word_bytes)
      append_folded(raw_, code);
  }

  // Whether a character that is no letter belongs to the word. Appends what is
  // kept of it: the apostrophe of a contraction, and the signs between digits.
  bool joins(Character character) {
    const auto next = peek(character.length);
    if (at_ == begin_ && character.code == '+') {
      raw_ += '+';
      return true;
    }
    if (is_apostrophe(character.code) && is_word_character(next)) {
      raw_ += '\'';
      return true;
    }
    if (is_digit(previous_) && is_digit(next))
      return joins_digits(character.code);
    return character.code == '.' && is_initial(next);
  }

  // "1,000" loses its comma; "10:30", "9123-4567" and "2.5" keep their sign.
  bool joins_digits(char32_t code) {
    if (code == ',')
      return true;
    if (code != '.' && code != ':' && code != '-' && code != '/')
      return false;
    raw_ += static_cast<char>(code);
    return true;
  }

  // "a.m." is one word: single letters between full stops.
  bool is_initial(char32_t next) const {
    const auto after = peek(2);
    return raw_.size() <= 4 && next < 0x80 && !is_digit(next) &&
           is_word_character(next) && !is_word_character(after) &&
           (raw_.size() == 1 || text_[at_ - 2] == '.');
  }

  // Adds the word. A contraction becomes the tokens that it means, which share
  // the bytes of the text at the apostrophe; a possessive loses its "'s".
  void push() {
    if (const auto meant = contraction(raw_); !meant.empty())
      return push_all(meant);
    // "Ho's" is Ho. "What floor's the bank on" and "the toilet's blocked" have
    // no possessive.
    if (raw_.size() > 2 && raw_.ends_with("'s")) {
      raw_.resize(raw_.size() - 2);
      if (is_asked_for() || follows_is(next_word())) {
        const auto middle = middle_of_contraction();
        push(raw_, begin_, middle);
        break_ = Break::none;
        return push("is", middle, at_);
      }
    }
    std::erase(raw_, '\'');
    if (!raw_.empty())
      push(raw_, begin_, at_);
  }

  void push_all(std::string_view words) {
    const auto middle = middle_of_contraction();
    for (auto begin = begin_;; begin = middle) {
      const auto blank = words.find(' ');
      const bool is_last = blank == std::string_view::npos;
      push(std::string(words.substr(0, blank)), begin, is_last ? at_ : middle);
      if (is_last)
        return;
      break_ = Break::none;
      words.remove_prefix(blank + 1);
    }
  }

  // "what time's dinner"
  bool is_asked_for() const {
    return !tokens_.list.empty() && break_ == Break::none &&
           (tokens_.list.back().word == "what" ||
            tokens_.list.back().word == "which");
  }

  // In small letters; empty at a full stop, a comma or the like.
  std::string next_word() const {
    const auto begin = text_.find_first_not_of(' ', at_);
    if (begin == std::string_view::npos || begin == at_)
      return {};
    std::string word;
    for (auto at = begin; at < text_.size(); ++at) {
      const auto letter = static_cast<unsigned char>(text_[at]);
      if (std::isalpha(letter) == 0)
        break;
      word += static_cast<char>(std::tolower(letter));
    }
    return word;
  }

  // \xE2 is the first byte of a typographic apostrophe.
  std::size_t middle_of_contraction() const {
    const auto part = text_.substr(begin_, at_ - begin_);
    const auto apostrophe = part.find_first_of("'\xE2`");
    return apostrophe == std::string_view::npos ? at_ : begin_ + apostrophe;
  }

  void push(std::string word, std::size_t begin, std::size_t end) {
    tokens_.list.push_back({static_cast<std::uint32_t>(begin),
                            static_cast<std::uint32_t>(end), std::move(word),
                            break_});
  }

  std::string_view text_;
  bool has_email_; // it may
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  std::string raw_;
  char32_t previous_ = 0;
  Break break_ = Break::none;
  Tokens tokens_;
};

} // namespace

Tokens tokenize(std::string_view text) {
  return Tokenizer(text).run();
}

TokenRange stretch_of(const Tokens& tokens, TokenRange range, Break by) {
  const auto& list = tokens.list;
  // Nothing stands around what begins behind the last token.
  if (range.begin >= list.size())
    return range;
  while (range.begin > 0 && list[range.begin].before < by)
    --range.begin;
  while (range.end < list.size() && list[range.end].before < by)
    ++range.end;
  return range;
}

std::string_view words_of(std::string_view text, const Tokens& tokens,
                          std::size_t first, std::size_t last) {
  if (first >= last || last > tokens.list.size())
    return {};
  const auto begin = tokens.list[first].begin;
  return text.substr(begin, tokens.list[last - 1].end - begin);
}

} // namespace parlour::adapters::nlu
