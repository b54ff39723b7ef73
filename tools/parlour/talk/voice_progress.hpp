// VoiceProgress: what a conversation by voice is doing, and how loud the
// microphone is, as one line that is drawn again and again on a terminal.
//
//   hearing you  [########            ] -36 dB
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "adapters/audio/level_meter.hpp"
#include "runtime/message/message.hpp"

namespace parlour::tools {

// "[########            ] -36 dB": the level, from -60 dB to full scale.
std::string level_bar(const adapters::LevelMeter& level);

// Safe to use from any thread.
class VoiceProgress {
public:
  // The roles of components by their names.
  using Roles = std::map<std::string, std::string, std::less<>>;

  // `sleeps`: until its word is said, and after silence.
  explicit VoiceProgress(Roles roles, bool sleeps = false)
      : roles_(std::move(roles)), sleeps_(sleeps) {}

  // A message of the run. Returns the line if it is to be drawn again: what is
  // done has changed, or 200 ms of sound were heard.
  std::optional<std::string> take(const Message& message);
  // The line as it is now.
  std::string line() const;

private:
  enum class Doing : std::uint8_t {
    loading,
    asleep,
    listening,
    hearing,
    thinking,
    speaking,
    deaf
  };

  std::string line_now() const; // while mutex_ is held
  // Each returns whether the line has changed.
  bool heard(const Message& message);
  bool change(Doing doing);
  std::optional<Doing> next(std::string_view role,
                            std::string_view command) const;

  const Roles roles_;
  const bool sleeps_;
  mutable std::mutex mutex_;
  Doing doing_ = Doing::loading;
  adapters::LevelMeter now_;   // that is being measured
  adapters::LevelMeter shown_; // that was measured last
};

} // namespace parlour::tools
