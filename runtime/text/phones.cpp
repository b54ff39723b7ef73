#include "runtime/text/phones.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "runtime/text/words.hpp"

namespace parlour {

namespace {

constexpr std::string_view phones[] = {
    "AA", "AE", "AH", "AO", "AW", "AY", "B",  "CH", "D",  "DH",
    "EH", "ER", "EY", "F",  "G",  "HH", "IH", "IY", "JH", "K",
    "L",  "M",  "N",  "NG", "OW", "OY", "P",  "R",  "S",  "SH",
    "T",  "TH", "UH", "UW", "V",  "W",  "Y",  "Z",  "ZH"};

std::string upper_without_stress(std::string text) {
  while (!text.empty() && std::isdigit(static_cast<unsigned char>(text.back())))
    text.pop_back();
  std::ranges::transform(text, text.begin(), [](unsigned char c) {
    return static_cast<char>(std::toupper(c));
  });
  return text;
}

std::string all_phones() {
  std::string all;
  for (const auto phone : phones)
    all.append(all.empty() ? "" : " ").append(phone);
  return all;
}

} // namespace

bool is_phone(std::string_view text) {
  return std::ranges::find(phones, text) != std::end(phones);
}

std::optional<std::string> mistake_in_phones(std::string_view text) {
  const auto parts = split_words(text);
  for (const auto& part : parts) {
    if (is_phone(part))
      continue;
    const auto near = upper_without_stress(part);
    return "there is no phone '" + part + "'; " +
           (is_phone(near) ? "did you mean '" + near + "'?"
                           : "the phones are " + all_phones());
  }
  if (parts.empty())
    return "no phones are given; write them as in HH OW";
  return {};
}

std::string tidy_phones(std::string_view text) {
  std::string tidy;
  for (const auto& part : split_words(text))
    tidy.append(tidy.empty() ? "" : " ").append(part);
  return tidy;
}

} // namespace parlour
