// UtteranceQueue speaks the texts of one session one after the other. It
// delivers audio ahead of the time at which it can be heard, but not far ahead:
// a long text floods nobody, and what was not delivered yet can be stopped.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "adapters/tts/speech_engine.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::tts {

struct Utterance {
  Message order; // Speak, for its answers
  std::int64_t id = 0;
  std::string text;
  VoiceSettings settings;
};

// How audio is delivered.
struct Pace {
  Milliseconds ahead{2'000};
  // Wait for the engine instead of being woken by it: for virtual time, which
  // must not go on meanwhile.
  bool waits = false;
};

// What is told of an utterance. The functions are called on the plug-in's own
// thread.
struct SpeechCalls {
  std::function<void(const Utterance& one, Value frame)> audio;
  std::function<void(const Utterance& one, const SpokenWord& word)> mark;
  std::function<void(const Utterance& one)> finished;
  std::function<void(const Utterance& one, const std::string& reason)> failed;
};

// Used on the plug-in's own thread. Create it by make_shared: the engine wakes
// it only as long as somebody owns it.
class UtteranceQueue : public std::enable_shared_from_this<UtteranceQueue> {
public:
  // The host, the engine and the functions outlive it.
  UtteranceQueue(PluginHost& host, SpeechEngine& engine, Pace pace,
                 const SpeechCalls& calls);
  UtteranceQueue(const UtteranceQueue&) = delete;
  UtteranceQueue& operator=(const UtteranceQueue&) = delete;
  // Nothing is told any more.
  ~UtteranceQueue();

  void add(Utterance utterance);
  // Ends this utterance, or all; each is told to be finished.
  void stop(std::optional<std::int64_t> id);
  std::size_t size() const {
    return waiting_.size();
  }

private:
  void begin();
  void deliver();
  void tell(const Portion& portion);
  // Ends the first utterance; the next one begins.
  void end(const std::string& trouble);
  void silence();
  // Until where audio may be delivered now, in ms.
  std::int64_t due() const;

  PluginHost& host_;
  SpeechEngine& engine_;
  const Pace pace_;
  const SpeechCalls& calls_;
  std::deque<Utterance> waiting_;  // the first one is being spoken
  std::shared_ptr<SpeechJob> job_; // of the first; null: none has begun
  // When its first sound was delivered.
  std::optional<Timestamp> begun_;
  PluginHost::DelayId delay_ = 0;
};

} // namespace parlour::adapters::tts
