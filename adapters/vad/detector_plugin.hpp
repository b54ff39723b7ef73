// A plug-in of the role VAD around a detector:
//
//  Process(audio, position?)
//      Takes the next audio. SpeechStarted(position) and SpeechEnded(position)
//      tell where speech began and ended.
//  SetEcho(audio)
//      What the loudspeaker plays now.
//  Reset()
//      The next audio is another stream, from position 0.
//
// Each session has a detector of its own; the least recently used is dropped
// when there are too many.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "adapters/vad/speech_detector.hpp"
#include "runtime/plugin/adaptors.hpp"

namespace parlour::adapters {

class DetectorPlugin : public VADPlugin {
public:
  using MakeDetector =
      std::function<Expected<std::unique_ptr<SpeechDetector>>(const Options&)>;

  explicit DetectorPlugin(MakeDetector make);

protected:
  Expected<void> on_start(const Options& options) override;
  void on_process(const Binary& audio,
                  std::optional<std::int64_t> position) override;
  void on_set_echo(const Binary& audio) override;
  void on_reset() override;

private:
  struct Stream {
    std::unique_ptr<SpeechDetector> detector;
    std::uint64_t used = 0;
  };

  // That of the message's session; null if none can be made.
  SpeechDetector* detector();
  void drop_least_used();

  MakeDetector make_;
  Options options_;
  std::map<SessionId, Stream> streams_;
  std::uint64_t uses_ = 0;
};

} // namespace parlour::adapters
