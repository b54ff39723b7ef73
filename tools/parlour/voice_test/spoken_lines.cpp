#include "tools/parlour/voice_test/spoken_lines.hpp"

#include <algorithm>
#include <sstream>

#include "tools/parlour/voice_test/voice_user.hpp"

namespace parlour::tools {

namespace {

// In virtual time: until the robot answers.
constexpr Milliseconds longest_answer{10'000};
// What `B(…):` without words is: no word of any language.
constexpr std::int64_t sniff_length = 400; // ms

std::size_t count_words(const std::string& text) {
  std::istringstream words(text);
  std::size_t count = 0;
  for (std::string word; words >> word;)
    ++count;
  return count;
}

class Seat : public SpokenSeat {
public:
  Seat(const SpokenLines& lines, KeptComponents& recognisers)
      : lines_(lines), user_({}, true, &recognisers) {}

  Composition seated(Composition composition,
                     const std::filesystem::path& data) override {
    return user_.seated(std::move(composition), data);
  }
  void note(const Inspection& seen) override {
    user_.log().note(seen);
  }
  void released(std::uint64_t id, const std::string& text) override {
    user_.log().released(id, text);
  }
  void settle(actors::Node& node) override {
    node.run_until_quiet();
    user_.settle(node);
    is_new_ = true;
  }

  void speak(actors::Node& node, const Step& step) override {
    begin(node, step);
    user_.surround(lines_.noise(step));
    if (step.kind == StepKind::partial)
      user_.begin(node, lines_.line(step));
    else
      user_.say(node, lines_.line(step));
    user_.surround({});
    goes_on_ = step.kind == StepKind::partial;
  }

  std::optional<Milliseconds> first_sound(actors::Node& node) override {
    const auto& latencies = user_.log().latencies();
    VoiceUser::until(
        node, [&] { return !latencies.empty(); }, longest_answer);
    if (latencies.empty())
      return std::nullopt;
    return latencies.back().all();
  }

private:
  // Waits for the moment at which the user begins to speak.
  void begin(actors::Node& node, const Step& step) {
    const bool goes_on = std::exchange(goes_on_, false);
    if (goes_on)
      return;
    if (step.kind == StepKind::barge_in)
      user_.wait_for_words(node, count_words(step.target));
    else if (std::exchange(is_new_, false))
      user_.think(node);
    else
      user_.wait_to_cut_in(node);
    user_.log().begin_row();
  }

  const SpokenLines& lines_;
  VoiceUser user_;
  bool is_new_ = true;   // nothing was spoken since the robot ended
  bool goes_on_ = false; // what was spoken last is the beginning of this
};

} // namespace

SpokenLines::SpokenLines(Application application, const TestSuite& suite,
                         std::shared_ptr<PluginCatalogue> voices)
    : application_(std::move(application)), bank_(std::move(voices)),
      sniff_(adapters::pink_noise(1, sniff_length, SpeechBank::level)) {
  for (const auto& conversation : suite.conversations)
    for (const auto& step : conversation.steps)
      if (!step.voice.empty())
        add(conversation, step);
}

void SpokenLines::add(const Conversation& conversation, const Step& step) {
  const auto complain = [&](const Error& error) {
    findings_.push_back({script::Severity::error,
                         {conversation.file, step.line, 1},
                         error.message});
  };
  if (!step.text.empty())
    if (const auto spoken = bank_.speak(step.text, step.voice); !spoken)
      return complain(spoken.error());
  const auto wish = read_noise(step.noise);
  if (!wish)
    return complain(wish.error());
  auto made = make_noise(*wish, step.voice, bank_);
  if (!made)
    return complain(made.error());
  noises_[{step.voice, step.noise}] = std::move(*made);
}

std::unique_ptr<SpokenSeat> SpokenLines::make() {
  return std::make_unique<Seat>(*this, recognisers_);
}

const adapters::Sound& SpokenLines::line(const Step& step) const {
  return step.text.empty() ? sniff_ : *bank_.find(step.text, step.voice);
}

const adapters::Sound& SpokenLines::noise(const Step& step) const {
  return noises_.at({step.voice, step.noise});
}

bool is_spoken(const TestSuite& suite) {
  return std::ranges::any_of(suite.conversations, [](const auto& conversation) {
    return is_spoken(conversation);
  });
}

} // namespace parlour::tools
