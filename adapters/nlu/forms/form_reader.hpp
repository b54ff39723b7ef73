// A reader of tokens for the normal forms: looks at words from one position on
// and moves past what it has understood.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>

#include "adapters/nlu/forms/normal_forms.hpp"
#include "adapters/nlu/forms/number_words.hpp"

namespace parlour::adapters::nlu {

class FormReader {
public:
  FormReader(const Tokens& tokens, std::size_t position)
      : tokens_(&tokens), begin_(position), at_(position) {}

  // "" past the end, and past a break after the first word.
  std::string_view word(std::size_t ahead = 0) const {
    const auto place = at_ + ahead;
    if (place >= tokens_->list.size())
      return {};
    if (place > begin_ && tokens_->list[place].before == Break::sentence)
      return {};
    return tokens_->list[place].word;
  }

  // The word before all that is read; "" where it begins with the text.
  std::string_view word_before() const {
    return begin_ == 0 ? std::string_view() : tokens_->list[begin_ - 1].word;
  }

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

  // All of these words in a row, or none is skipped.
  bool skip_all(std::initializer_list<std::string_view> expected) {
    std::size_t ahead = 0;
    for (const auto one : expected)
      if (word(ahead++) != one)
        return false;
    at_ += expected.size();
    return true;
  }

  std::optional<NumberAt> number() {
    if (word().empty())
      return {};
    const auto found = number_at(*tokens_, at_);
    at_ += found ? found->length : 0;
    return found;
  }

  // The same, or "a couple of" and the like.
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
  void go_back(std::size_t position) {
    at_ = position;
  }
  std::size_t length() const {
    return at_ - begin_;
  }

  FormAt form(Value value, bool weak = false) const {
    return {std::move(value), length(), weak};
  }

private:
  const Tokens* tokens_;
  std::size_t begin_;
  std::size_t at_;
};

// "double" and "triple" in front of a digit: how often it is meant.
std::size_t repeats(FormReader& reader);

// A number as its digits are said, one by one ("four seven one one", "double
// four seven") or by two ("forty seven eleven"); one of two digits only where
// nothing else is said. Nothing where it is a sum, as most numbers are.
std::optional<std::int64_t> spelled_number(FormReader& reader);

// One function for each form; the table is in normal_forms.cpp.
std::optional<FormAt> time_form(FormReader reader, Now now);
std::optional<FormAt> date_form(FormReader reader, Now now);
std::optional<FormAt> number_form(FormReader reader, Now now);
std::optional<FormAt> duration_form(FormReader reader, Now now);
std::optional<FormAt> phone_form(FormReader reader, Now now);
std::optional<FormAt> email_form(FormReader reader, Now now);
std::optional<FormAt> level_form(FormReader reader, Now now);

} // namespace parlour::adapters::nlu
