// TextFileTTS: a voice on paper (role TTS). What it speaks is written to a file
// of the data folder, a line each, in the time that speaking it would take, so
// that whoever waits for a voice can be tried without any sound.
//
//   Speak(text, utterance, interruptible?)   one after the other:
//                 Mark(utterance, word, position) as each word begins, then
//                 Finished(utterance); Failed(reason) where too much waits
//   Stop(utterance?)   that one, or all of the session; each of them ends with
//                 Finished
//   SetVoice(name)     written before what follows
//
// Options: file (speech.txt); rate, words a minute (180; 0: in no time, without
// marks).
#pragma once

#include <deque>
#include <fstream>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

class TextFileTTS : public IPlugin {
public:
  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;
  void on_message(const Message& message) override;

private:
  struct Utterance {
    Message order;
    std::string text;
    Value name; // as Speak gave it
  };

  void speak(const Message& order);
  void stop_speaking(const SessionId& session, const Value& utterance);
  void begin();
  void next_word();
  void end();
  void finish(const Utterance& utterance);
  void write(const Utterance& utterance);

  std::ofstream file_;
  std::string voice_;
  Milliseconds word_time_{};
  std::deque<Utterance> waiting_;  // the first one is being spoken
  std::vector<std::string> words_; // of the first one
  std::size_t spoken_ = 0;
  PluginHost::DelayId delay_ = 0; // 0: none
};

PluginFactory text_file_tts_factory();

} // namespace parlour::adapters
