#include "tools/parlour/voice_test/user_microphone.hpp"

#include <algorithm>
#include <utility>

#include "runtime/plugin/adaptors.hpp"

namespace parlour::tools {

namespace {

using adapters::Sound;

class UserMicrophone : public MicrophonePlugin {
public:
  explicit UserMicrophone(std::shared_ptr<UserSound> sound)
      : sound_(std::move(sound)) {}

  void stop() override {
    host().cancel(std::exchange(delay_, 0));
  }

protected:
  void on_start_mic() override {
    fire_started();
    if (delay_ == 0)
      wait();
  }
  void on_stop_mic() override {
    stop();
    fire_stopped();
  }

private:
  void wait() {
    delay_ = host().after(Milliseconds(adapters::frame_time), [this] {
      answer({}, "BufferFull",
             {adapters::pcm_value(sound_->next()), position_});
      position_ += adapters::frame_time;
      wait();
    });
  }

  std::shared_ptr<UserSound> sound_;
  std::int64_t position_ = 0;
  PluginHost::DelayId delay_ = 0;
};

} // namespace

UserSound::UserSound(Sound noise) : noise_(std::move(noise)) {}

void UserSound::say(const Sound& line) {
  std::lock_guard lock(mutex_);
  line_.insert(line_.end(), line.begin(), line.end());
}

void UserSound::surround(Sound noise) {
  std::lock_guard lock(mutex_);
  noise_ = std::move(noise);
  at_ = 0;
}

bool UserSound::is_silent() const {
  std::lock_guard lock(mutex_);
  return line_.empty();
}

Sound UserSound::next() {
  std::lock_guard lock(mutex_);
  Sound frame(adapters::frame_samples);
  for (std::size_t i = 0; i < frame.size() && !noise_.empty(); ++i) {
    frame[i] = noise_[at_];
    at_ = at_ + 1 == noise_.size() ? 0 : at_ + 1;
  }
  const auto count = std::min(line_.size(), frame.size());
  const auto end = line_.begin() + static_cast<std::ptrdiff_t>(count);
  adapters::add(frame, Sound(line_.begin(), end));
  line_.erase(line_.begin(), end);
  return frame;
}

PluginFactory user_microphone_factory(std::shared_ptr<UserSound> sound) {
  PluginDescription description;
  description.name = "UserMicrophone";
  description.roles = {"Microphone"};
  description.sentence = "hears a simulated user";
  return {std::move(description),
          [sound] { return std::make_unique<UserMicrophone>(sound); }};
}

} // namespace parlour::tools
