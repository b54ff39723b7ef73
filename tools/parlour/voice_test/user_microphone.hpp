// UserMicrophone hears a simulated user: lines that a test gives it while the
// conversation runs, silence between them, and a noise behind all of it.
#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "adapters/audio/mixing.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// What the user says; shared by the test and the plug-in. Thread-safe.
class UserSound {
public:
  // The noise is repeated; it may be empty.
  explicit UserSound(adapters::Sound noise = {});

  void say(const adapters::Sound& line);
  // Another noise from now on.
  void surround(adapters::Sound noise);
  // All lines have been heard.
  bool is_silent() const;
  // The next 20 ms.
  adapters::Sound next();

private:
  mutable std::mutex mutex_;
  adapters::Sound noise_;
  std::size_t at_ = 0; // in the noise
  std::deque<adapters::Sample> line_;
};

// Role Microphone: start_mic, stop_mic, BufferFull every 20 ms. It lives by the
// host's delays, so in virtual time it takes no time.
PluginFactory user_microphone_factory(std::shared_ptr<UserSound> sound);

} // namespace parlour::tools
