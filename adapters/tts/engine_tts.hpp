// EngineTTS is what the plug-ins of the role TTS have in common that speak by a
// library: each adds the options' defaults and the engine.
//
//  Speak(text, utterance, interruptible?)
//      Audio(audio, utterance) frame by frame, and Mark(utterance, word,
//      position) before the frame in which a word begins; then
//      Finished(utterance). Audio comes up to `ahead` before it can be heard.
//      The texts of a session are spoken one after the other, those of several
//      sessions side by side. Failed(reason): the text is too long, or too many
//      wait.
//  Stop(utterance?)
//      Ends this utterance, or all of the session, each with Finished.
//  SetVoice(name)
//      For what the session says from now on. Failed(reason): there is none.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "adapters/tts/utterance_queue.hpp"
#include "runtime/plugin/adaptors.hpp"

namespace parlour::adapters::tts {

// Options: voice, rate, pitch, volume, ahead, one-by-one. `voice` is the
// default.
std::vector<OptionDescription> voice_options(const std::string& voice);

class EngineTTS : public TTSPlugin {
public:
  // In characters.
  static constexpr std::size_t longest_text = 10'000;
  // Over all sessions.
  static constexpr std::size_t max_waiting = 100;

  // `options` are those of the description. The engine must outlive the
  // plug-in.
  EngineTTS(SharedEngine& engine, std::vector<OptionDescription> options);
  ~EngineTTS() override;

  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;
  void on_speak(const std::string& text, Utterance utterance,
                std::optional<bool> interruptible) override;
  void on_stop(std::optional<Utterance> utterance) override;
  void on_set_voice(const std::string& name) override;

private:
  using Queue = std::shared_ptr<UtteranceQueue>;

  Expected<void> read(const Options& options);
  SpeechCalls calls();
  const std::string& voice_of(const SessionId& session) const;
  std::size_t waiting() const;
  void forget_idle();
  Expected<void> check_voice(const std::string& name);

  SharedEngine& shared_;
  const std::vector<OptionDescription> descriptions_;
  const SpeechCalls calls_;
  VoiceSettings settings_;
  Pace pace_;
  std::shared_ptr<SpeechEngine> engine_; // null: not started
  // Those that have something to say.
  std::map<SessionId, Queue> queues_;
  // The voices that were set, the latest last.
  std::deque<std::pair<SessionId, std::string>> voices_;
};

} // namespace parlour::adapters::tts
