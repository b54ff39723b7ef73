#include "tools/parlour/voice_test/voice_suite.hpp"

#include <algorithm>
#include <numeric>

#include "tools/parlour/console/in_parallel.hpp"
#include "tools/parlour/voice_test/read_aloud.hpp"

namespace parlour::tools {

namespace {

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const auto& text : texts)
    all += (all.empty() ? "" : " ") + text;
  return all;
}

// Speaks all lines, so that nothing has to be spoken while conversations run.
Expected<void> fill(SpeechBank& bank, const TestSuite& suite,
                    const std::string& voice) {
  for (const auto& conversation : suite.conversations)
    for (const auto& step : conversation.steps)
      if (step.kind == StepKind::user)
        if (const auto spoken = bank.speak(step.text, voice); !spoken)
          return tl::make_unexpected(spoken.error());
  return {};
}

// Row after row; where one went wrong, again from the row behind it.
void hold(const Application& spoken, const Conversation& conversation,
          const Speaking& speaking, VoiceResult& result) {
  while (result.found.size() < result.expected.size()) {
    const auto typed = result.found.size();
    auto held =
        hold_by_voice(spoken, conversation, speaking, result.expected, typed);
    result.trouble = held.trouble;
    if (held.rows.size() <= typed)
      return;
    std::move(held.rows.begin() + static_cast<std::ptrdiff_t>(typed),
              held.rows.end(), std::back_inserter(result.found));
  }
}

VoiceResult hold(const Application& typed, const Application& spoken,
                 const Conversation& conversation, const Speaking& speaking) {
  VoiceResult result{
      conversation.file, speaking.voice, {}, {}, unspeakable(conversation)};
  if (!result.trouble.empty())
    return result;
  auto expected = hold_by_text(typed, conversation);
  result.expected = std::move(expected.rows);
  result.trouble = std::move(expected.trouble);
  if (result.trouble.empty())
    hold(spoken, conversation, speaking, result);
  return result;
}

} // namespace

Expected<std::vector<VoiceResult>>
hold_by_voices(const Application& typed, const Application& spoken,
               const TestSuite& suite, const VoiceWish& wish,
               std::shared_ptr<PluginCatalogue> voices) {
  KeptComponents recognisers;
  SpeechBank bank(std::move(voices));
  std::vector<Speaking> speaking;
  for (const auto& voice : wish.voices) {
    if (auto filled = fill(bank, suite, voice); !filled)
      return tl::make_unexpected(filled.error());
    auto noise = make_noise(wish.noise, voice, bank);
    if (!noise)
      return tl::make_unexpected(noise.error());
    speaking.push_back(
        {&bank, voice, std::move(*noise), wish.told, &recognisers});
  }
  const auto& conversations = suite.conversations;
  std::vector<VoiceResult> results(conversations.size() * speaking.size());
  in_parallel(results.size(), wish.jobs, [&](std::size_t i) {
    results[i] = hold(typed, spoken, conversations[i % conversations.size()],
                      speaking[i / conversations.size()]);
  });
  return results;
}

VoiceScore score_of(const std::vector<VoiceResult>& results,
                    const std::string& voice) {
  VoiceScore score;
  for (const auto& result : results) {
    if (result.voice != voice)
      continue;
    for (std::size_t i = 0; i < result.found.size(); ++i) {
      const auto& row = result.found[i];
      ++score.rows;
      score.words +=
          count_word_errors(read_aloud(joined(row.said)), joined(row.heard));
      score.right += row.understood == result.expected[i].understood;
      score.answered += row.is_as(result.expected[i]);
      score.latencies.insert(score.latencies.end(), row.latencies.begin(),
                             row.latencies.end());
    }
  }
  std::ranges::sort(score.latencies, {}, &Latency::all);
  return score;
}

Milliseconds percentile(const std::vector<Latency>& sorted, int percent) {
  if (sorted.empty())
    return Milliseconds(0);
  const auto last = sorted.size() - 1;
  return sorted[(last * static_cast<std::size_t>(percent) + 50) / 100].all();
}

} // namespace parlour::tools
