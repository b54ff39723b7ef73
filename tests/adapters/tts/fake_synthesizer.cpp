#include "tests/adapters/tts/fake_synthesizer.hpp"

namespace parlour::test {

using namespace adapters;
using namespace adapters::tts;

void FakeSynthesizerState::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  has_caller_ = false;
}

void FakeSynthesizerState::open() {
  const std::lock_guard lock(mutex_);
  closed_ = false;
  changed_.notify_all();
}

void FakeSynthesizerState::wait_for_caller() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return has_caller_; });
}

int FakeSynthesizerState::words_spoken() const {
  const std::lock_guard lock(mutex_);
  return words_;
}

int FakeSynthesizerState::instances() const {
  const std::lock_guard lock(mutex_);
  return instances_;
}

std::vector<std::string> FakeSynthesizerState::voices() const {
  const std::lock_guard lock(mutex_);
  return voices_;
}

class FakeSynthesizer : public Synthesizer {
public:
  explicit FakeSynthesizer(FakeSynthesizerState& state) : state_(state) {
    const std::lock_guard lock(state_.mutex_);
    ++state_.instances_;
  }
  ~FakeSynthesizer() override {
    const std::lock_guard lock(state_.mutex_);
    --state_.instances_;
  }
  FakeSynthesizer(const FakeSynthesizer&) = delete;
  FakeSynthesizer& operator=(const FakeSynthesizer&) = delete;

  PieceLength piece_length() const override {
    return state_.length;
  }
  Expected<void> check_voice(const std::string& voice) override {
    if (voice == "anna" || voice == "berta")
      return {};
    return fail(ErrorKind::settings, "there is no voice '" + voice + "'");
  }
  Expected<void> speak(const Words& piece, bool, const VoiceSettings& settings,
                       SpeechSink& sink) override {
    note(settings.voice);
    std::int64_t position = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (piece[i] == "fail")
        return fail(ErrorKind::limit, "it cannot say this");
      if (piece[i] == state_.silent)
        continue;
      pass_the_gate();
      sink.word(i, position);
      position += 100;
      const std::vector<Sample> sound(
          static_cast<std::size_t>(state_.rate) / 10, fake_sample);
      if (!sink.sound(sound, state_.rate))
        return {};
    }
    return {};
  }

private:
  void note(const std::string& voice) {
    const std::lock_guard lock(state_.mutex_);
    state_.voices_.push_back(voice);
  }
  void pass_the_gate() {
    std::unique_lock lock(state_.mutex_);
    state_.has_caller_ = true;
    state_.changed_.notify_all();
    state_.changed_.wait(lock, [this] { return !state_.closed_; });
    ++state_.words_;
  }

  FakeSynthesizerState& state_;
};

Expected<std::unique_ptr<Synthesizer>>
make_fake_synthesizer(FakeSynthesizerState& state) {
  if (state.is_missing)
    return fail(ErrorKind::settings, "the library is not installed");
  return std::make_unique<FakeSynthesizer>(state);
}

} // namespace parlour::test
