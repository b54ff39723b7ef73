#include "tools/bench/speech/sentences.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

namespace parlour::tools {

namespace {

constexpr std::array<std::string_view, 10> digit_names{
    "zero", "one", "two",   "three", "four",
    "five", "six", "seven", "eight", "nine"};

// The digit of a name; 0 for a word that is none.
char digit_of(const std::string& word) {
  if (word == "oh" || word == "o")
    return '0';
  const auto name = std::ranges::find(digit_names, word);
  return name == digit_names.end()
             ? '\0'
             : static_cast<char>('0' + (name - digit_names.begin()));
}

bool is_digit(char one) {
  return one >= '0' && one <= '9';
}

} // namespace

Sentences read_sentences(std::istream& in) {
  Sentences sentences;
  for (std::string line; std::getline(in, line);)
    if (const auto tab = line.find('\t');
        tab != std::string::npos && !line.starts_with('#'))
      sentences[line.substr(0, tab)].push_back(line.substr(tab + 1));
  return sentences;
}

Expected<Sentences> read_sentences(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    return fail(ErrorKind::file, file.string() + " cannot be read");
  return read_sentences(in);
}

std::string digits_in(std::string_view text) {
  std::string digits;
  std::string word;
  bool twice = false;
  const auto add = [&](char digit) {
    digits.append(twice ? 2 : 1, digit);
    twice = false;
  };
  const auto end_word = [&] {
    if (const auto digit = digit_of(word))
      add(digit);
    else if (word == "double")
      twice = true;
    word.clear();
  };
  for (const char one : text) {
    if (std::isalpha(static_cast<unsigned char>(one))) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(one)));
      continue;
    }
    end_word();
    if (is_digit(one))
      add(one);
  }
  end_word();
  return digits;
}

} // namespace parlour::tools
