// SpeechBank speaks the lines of users: each line by a voice of FliteTTS or
// EspeakTTS, made once. It is filled before the conversations begin, because
// making speech would disturb what they measure.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "adapters/audio/mixing.hpp"
#include "runtime/plugin/catalogue.hpp"
#include "runtime/plugin/test_host.hpp"

namespace parlour::tools {

// For one thread, but for find().
class SpeechBank {
public:
  // The level of all lines, in dB of full scale.
  static constexpr double level = -26;

  // Keeps the catalogue.
  explicit SpeechBank(std::shared_ptr<PluginCatalogue> plugins);
  ~SpeechBank();

  // The line without silence at its ends, at the level. An error: nobody has
  // the voice, or it cannot speak the text. What is returned lives as long as
  // the bank.
  Expected<const adapters::Sound*> speak(const std::string& text,
                                         const std::string& voice);
  // A line that was spoken before; null if it was not. From any thread, while
  // nothing is spoken.
  const adapters::Sound* find(const std::string& text,
                              const std::string& voice) const;

private:
  struct Voice {
    TestHost host;
    std::unique_ptr<IPlugin> plugin;
    std::int64_t utterances = 0;
  };

  // Null: the plug-in does not have the voice.
  std::unique_ptr<Voice> make(const std::string& plugin,
                              const std::string& name);
  Expected<Voice*> voice(const std::string& name);

  std::shared_ptr<PluginCatalogue> plugins_;
  std::map<std::string, std::unique_ptr<Voice>> voices_;
  // By voice and text.
  std::map<std::pair<std::string, std::string>, adapters::Sound> lines_;
};

} // namespace parlour::tools
