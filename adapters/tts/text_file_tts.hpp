// TextFileTTS is a plug-in for the role TTS that writes to a file of the data
// folder what a voice would speak, a line for each utterance. It takes the time
// that speaking would take, so that an application can be tried without sound.
//
//  Speak(text, utterance, interruptible?)
//      Mark(utterance, word, position) at the beginning of each word; position
//      in milliseconds; then Finished(utterance). Utterances are spoken one
//      after the other. Failed(reason) if too many wait.
//  Stop(utterance?)
//      Ends this utterance, or all of the session, each with Finished.
//  SetVoice(name)
//      Written before the lines that follow.
//
// Options: file (speech.txt); rate in words a minute (180). A rate of 0 takes
// no time and gives no marks.
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
    // As Speak gave it.
    Value name;
  };

  void speak(const Message& order);
  void stop_speaking(const SessionId& session, const Value& utterance);
  // Writes the first utterance in the queue and starts its words.
  void begin();
  void next_word();
  void end();
  void finish(const Utterance& utterance);
  void write(const Utterance& utterance);

  std::ofstream file_;
  std::string voice_;
  Milliseconds word_time_{};
  // The first one is being spoken.
  std::deque<Utterance> waiting_;
  // The words of the first utterance, and how many of them have been spoken.
  std::vector<std::string> words_;
  std::size_t spoken_ = 0;
  // The timer of the next word; 0: none.
  PluginHost::DelayId delay_ = 0;
};

PluginFactory text_file_tts_factory();

} // namespace parlour::adapters
