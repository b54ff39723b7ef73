#include "script/expression/slips.hpp"

#include <algorithm>
#include <cctype>

#include "script/source/findings.hpp"

namespace parlour::script {

namespace {

constexpr Slip table[] = {
#define SLIP(place, written, meant, sentence)                                  \
  {SlipPlace::place, written, meant, sentence},
#include "script/expression/slips.def"
#undef SLIP
};

std::string lower(std::string_view text) {
  std::string small;
  for (const char letter : text)
    small +=
        static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return small;
}

} // namespace

const Slip* find_slip(SlipPlace place, std::string_view written,
                      const std::vector<std::string>* allowed) {
  const auto small = lower(written);
  for (const auto& slip : table)
    if (slip.place == place && slip.written == small && slip.meant != written &&
        (!allowed || slip.meant.empty() ||
         std::find(allowed->begin(), allowed->end(), slip.meant) !=
             allowed->end()))
      return &slip;
  return nullptr;
}

bool explains(const Findings& findings) {
  constexpr std::size_t most_explained = 1000;
  return findings.all().size() <= most_explained;
}

} // namespace parlour::script
