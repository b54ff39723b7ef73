#include "adapters/nlu/text/name_sounds.hpp"

#include <algorithm>
#include <utility>

#include "adapters/nlu/text/phones.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// A word of a name, or the words of "s/o".
struct Part {
  std::string phones;
  bool joins = false;
};

// The tokenizer makes two words of "s/o".
bool is_child_of(const std::vector<std::string>& words, std::size_t at) {
  return at + 1 < words.size() && words[at + 1] == "o" &&
         (words[at] == "s" || words[at] == "d");
}

std::vector<Part> parts_of(const std::vector<std::string>& words) {
  std::vector<Part> parts;
  for (std::size_t at = 0; at < words.size(); ++at)
    if (is_child_of(words, at)) {
      const auto* const child = words[at] == "s" ? "son" : "daughter";
      parts.push_back({phones_of(child) + phones_of("of"), true});
      ++at;
    } else {
      parts.push_back({phones_of(words[at]), joins_names(words[at])});
    }
  return parts;
}

bool is_unlike(std::string_view heard, const Part& part, double least) {
  return !part.joins && sounds_alike(heard, part.phones, least) < least;
}

} // namespace

NameSounds sounds_of_name(const std::vector<std::string>& words) {
  NameSounds made;
  for (const auto& part : parts_of(words))
    made.phones += part.phones;
  made.kinds = sounds_in(made.phones);
  return made;
}

bool joins_names(const std::string& word) {
  return is_light(word) || is_title(word);
}

std::size_t words_unlike(std::string_view heard,
                         const std::vector<std::string>& name, double least) {
  const auto parts = parts_of(name);
  const auto all = parts.size() + 1; // more than can be unlike
  // By the end of what was heard of the parts so far.
  std::vector<std::size_t> unlike(heard.size() + 1, all);
  unlike[0] = 0;
  for (const auto& part : parts) {
    // What is heard for a part is hardly more than twice as long.
    const auto longest = 2 * part.phones.size() + 2;
    std::vector<std::size_t> next(heard.size() + 1, all);
    for (std::size_t begin = 0; begin <= heard.size(); ++begin) {
      if (unlike[begin] == all)
        continue;
      const auto last = std::min(heard.size(), begin + longest);
      for (auto end = begin; end <= last; ++end)
        if (unlike[begin] < next[end])
          next[end] = std::min(
              next[end],
              unlike[begin] +
                  (is_unlike(heard.substr(begin, end - begin), part, least)
                       ? 1U
                       : 0U));
    }
    unlike = std::move(next);
  }
  return unlike.back();
}

} // namespace parlour::adapters::nlu
