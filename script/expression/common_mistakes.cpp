// The table as an array, searched from the beginning: it is consulted only when
// something is wrong already.

#include "script/expression/common_mistakes.hpp"

#include <algorithm>
#include <cctype>

#include "script/source/findings.hpp"

namespace parlour::script {

namespace {

constexpr Mistake table[] = {
#define MISTAKE(place, written, meant, sentence)                               \
  {MistakePlace::place, written, meant, sentence},
#include "script/expression/common_mistakes.def"
#undef MISTAKE
};

std::string lower(std::string_view text) {
  std::string small;
  for (const char letter : text)
    small +=
        static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return small;
}

} // namespace

const Mistake* find_mistake(MistakePlace place, std::string_view written,
                            const std::vector<std::string>* allowed) {
  const auto small = lower(written);
  for (const auto& mistake : table)
    if (mistake.place == place && mistake.written == small &&
        mistake.meant != written &&
        (!allowed || mistake.meant.empty() ||
         std::find(allowed->begin(), allowed->end(), mistake.meant) !=
             allowed->end()))
      return &mistake;
  return nullptr;
}

bool explains(const Findings& findings) {
  constexpr std::size_t max_explained = 1000;
  return findings.all().size() <= max_explained;
}

} // namespace parlour::script
