#include "adapters/nlu/understand/left_sentences.hpp"

#include <algorithm>

namespace parlour::adapters::nlu {

namespace {

bool is_understood(TokenRange sentence, const std::vector<BuiltAct>& acts) {
  return std::ranges::any_of(acts, [&](const BuiltAct& act) {
    return act.begin < sentence.end && sentence.begin < act.end;
  });
}

} // namespace

std::vector<std::string_view>
left_sentences(const Utterance& utterance, const std::vector<BuiltAct>& acts) {
  std::vector<std::string_view> left;
  if (std::ranges::any_of(
          acts, [](const BuiltAct& act) { return act.topic != no_topic; }))
    return left;
  const auto size = static_cast<std::uint32_t>(utterance.size());
  for (std::uint32_t begin = 0; begin < size;) {
    const auto sentence =
        stretch_of(utterance.tokens, {begin, begin + 1}, Break::sentence);
    const bool is_all = sentence.begin == 0 && sentence.end == size;
    if (!is_all && utterance.has_content(sentence.begin, sentence.end) &&
        !is_understood(sentence, acts))
      left.push_back(
          words_of(utterance.text, utterance.tokens, begin, sentence.end));
    begin = sentence.end;
  }
  return left;
}

} // namespace parlour::adapters::nlu
