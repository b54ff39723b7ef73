// FormReader is a cursor over tokens with which the normal forms are parsed. It
// looks at the words from one position on and advances past those it has
// understood. Copying it is cheap: a function that takes a reader by value
// tries something without moving the caller's.
//
//  // "in three days"
//  if (reader.skip("in"))
//    if (const auto number = reader.number(); number && reader.skip("days"))
//      return reader.form(date_text(today + days(number->value)));
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "adapters/nlu/forms/normal_forms.hpp"
#include "adapters/nlu/forms/number_words.hpp"

namespace parlour::adapters::nlu {

// Refers to the tokens, which must outlive it.
class FormReader {
public:
  FormReader(const Tokens& tokens, std::size_t position)
      : tokens_(&tokens), begin_(position), at_(position) {}

  // The word `ahead` tokens further; empty at the end of the tokens or of the
  // sentence.
  std::string_view word(std::size_t ahead = 0) const {
    const auto place = at_ + ahead;
    if (place >= tokens_->list.size())
      return {};
    if (place > begin_ && tokens_->list[place].before == Break::sentence)
      return {};
    return tokens_->list[place].word;
  }

  // Whether the clause ends here, but for a courtesy.
  bool ends_clause() const {
    return word().empty() || tokens_->list[at_].before != Break::none ||
           (word() == "please" && word(1).empty());
  }

  // The word before the first one that was read; empty at the beginning of the
  // text.
  std::string_view word_before() const {
    return begin_ == 0 ? std::string_view() : tokens_->list[begin_ - 1].word;
  }

  // Each skip function advances past the expected words and says whether they
  // were there. skip_any takes one of them, skip_all takes all in a row or
  // none.
  bool skip(std::string_view expected) {
    const bool found = word() == expected;
    at_ += found ? 1 : 0;
    return found;
  }

  bool skip_any(std::initializer_list<std::string_view> expected) {
    for (const auto one : expected)
      if (skip(one))
        return true;
    return false;
  }

  bool skip_all(std::initializer_list<std::string_view> expected) {
    std::size_t ahead = 0;
    for (const auto one : expected)
      if (word(ahead++) != one)
        return false;
    at_ += expected.size();
    return true;
  }

  // Reads a number and advances past it.
  std::optional<NumberAt> number() {
    if (word().empty())
      return {};
    const auto found = number_at(*tokens_, at_);
    at_ += found ? found->length : 0;
    return found;
  }

  // The same, but also reads "a couple of", "half a dozen" and the like.
  std::optional<NumberAt> count() {
    if (word().empty())
      return {};
    const auto found = collective_at(*tokens_, at_);
    at_ += found ? found->length : 0;
    return found ? found : number();
  }

  void advance(std::size_t count = 1) {
    at_ += count;
  }
  std::size_t position() const {
    return at_;
  }
  // Where it began, and all tokens, for who looks beyond what is read.
  std::size_t begin() const {
    return begin_;
  }
  const Tokens& tokens() const {
    return *tokens_;
  }
  void go_back(std::size_t position) {
    at_ = position;
  }
  std::size_t length() const {
    return at_ - begin_;
  }

  // The result: a value, with all tokens that were read.
  FormAt form(Value value, bool weak = false) const {
    return {std::move(value), length(), weak};
  }

private:
  const Tokens* tokens_;
  std::size_t begin_;
  std::size_t at_;
};

// Advances past "no", "sorry, no" or "I mean" and says whether it was there.
bool skip_repair(FormReader& reader);

// Reads what is said again behind such words: digits stand for as many before
// them, or for all if there are more. They end a clause, or they are none: "no,
// one moment". `next` reads digits, empty for none.
template <class Next>
void repair_digits(FormReader& reader, std::string& digits, Next next) {
  auto start = reader.position();
  while (!digits.empty() && skip_repair(reader)) {
    const std::string again = next();
    if (again.empty() || !reader.ends_clause())
      break;
    digits.resize(digits.size() - std::min(digits.size(), again.size()));
    digits += again;
    start = reader.position();
  }
  reader.go_back(start);
}

// Reads "double" or "triple" before a digit. Returns 1 if there is neither.
std::size_t repeats(FormReader& reader);

// Reads a number from 10 to 99 in words, such as people say for two digits; 0
// if there is none.
std::int64_t two_digits(FormReader& reader);

// Reads a number that is said as digits: one by one ("four seven one one",
// "double four seven") or two by two ("forty seven eleven"). Two digits are
// enough only if nothing else is said. Nothing if it is an ordinary number,
// whose words add up.
std::optional<std::int64_t> spelled_number(FormReader& reader);

// One function for each form. They are listed in normal_forms.cpp.
std::optional<FormAt> time_form(FormReader reader, Now now);
std::optional<FormAt> date_form(FormReader reader, Now now);
std::optional<FormAt> number_form(FormReader reader, Now now);
std::optional<FormAt> duration_form(FormReader reader, Now now);
std::optional<FormAt> phone_form(FormReader reader, Now now);
std::optional<FormAt> email_form(FormReader reader, Now now);
std::optional<FormAt> level_form(FormReader reader, Now now);

} // namespace parlour::adapters::nlu
