// WyomingASR is a plug-in for the role ASR that has speech recognised by a
// server of the Wyoming protocol, such as faster-whisper or vosk.
//
//  DoRecognition(audio)
//      Goes to the server over a connection of the session's own, which the
//      first frame of a turn opens. Partial(text, revision) as the server says
//      what it hears.
//  Finish()
//      RecognitionResult(text, unknown, []), or Rejected(reason): nothing was
//      heard, or the server does not answer.
//  Cancel()
//      Drops the turn.
//  SetGrammar(names)
//      Ignored: the protocol has no grammars.
//
// Options: those of client.hpp; model, language.
#pragma once

#include <memory>
#include <string>

#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/open_messages.hpp"

namespace parlour::adapters {

// `open_` counts the turns whose Finish is not answered yet.
class WyomingASR : public ASRPlugin {
public:
  WyomingASR();
  ~WyomingASR() override;
  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;
  void on_do_recognition(const Binary& audio) override;
  void on_finish() override;
  void on_cancel() override;

private:
  class Turns;

  OpenMessages open_;
  std::unique_ptr<Turns> turns_;
};

PluginFactory wyoming_asr_factory();

} // namespace parlour::adapters
