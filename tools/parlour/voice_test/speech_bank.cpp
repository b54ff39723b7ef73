#include "tools/parlour/voice_test/speech_bank.hpp"

#include <algorithm>
#include <span>

#include "tools/parlour/application/plugin_calls.hpp"

namespace parlour::tools {

namespace {

using adapters::Sound;

constexpr Milliseconds patience{60'000};

Message order(std::string command, std::vector<Value> params) {
  Message message;
  message.command = std::move(command);
  message.params = std::move(params);
  message.session = "bank";
  return message;
}

// Adds the audio of the events; true once the utterance is over.
bool take(const std::vector<Message>& events, Sound& to, std::string& trouble) {
  bool is_over = false;
  for (const auto& event : events) {
    if (event.command == "Audio") {
      const auto samples = adapters::speech_samples(event.params.at(0));
      if (samples)
        to.insert(to.end(), samples->begin(), samples->end());
    } else if (event.command == "Failed") {
      trouble = event.params.empty() ? "it failed" : event.params[0].text();
    }
    is_over |= event.command == "Finished" || event.command == "Failed";
  }
  return is_over;
}

} // namespace

SpeechBank::SpeechBank(std::shared_ptr<PluginCatalogue> plugins)
    : plugins_(std::move(plugins)) {}

SpeechBank::~SpeechBank() {
  for (auto& [name, voice] : voices_)
    stop_plugin(*voice->plugin);
}

std::unique_ptr<SpeechBank::Voice> SpeechBank::make(const std::string& plugin,
                                                    const std::string& name) {
  const auto factory = plugins_->find(plugin);
  if (!factory)
    return nullptr;
  auto made = std::make_unique<Voice>();
  const Options options{
      {"voice", name}, {"ahead", "60s"}, {"one-by-one", "true"}};
  auto started = start_plugin(*factory, made->host, options);
  if (!started)
    return nullptr;
  made->plugin = std::move(*started);
  return made;
}

Expected<SpeechBank::Voice*> SpeechBank::voice(const std::string& name) {
  auto& kept = voices_[name];
  for (const auto* plugin : {"FliteTTS", "EspeakTTS"})
    if (!kept)
      kept = make(plugin, name);
  if (kept)
    return kept.get();
  voices_.erase(name);
  return fail(ErrorKind::settings,
              "neither flite nor espeak-ng has a voice '" + name +
                  "'; try slt, rms, awb, kal16 or en-us, or install them "
                  "(docs/speech.md)");
}

Expected<const Sound*> SpeechBank::speak(const std::string& text,
                                         const std::string& name) {
  if (const auto* spoken = find(text, name))
    return spoken;
  const auto by = voice(name);
  if (!by)
    return tl::make_unexpected(by.error());
  auto& host = (*by)->host;
  Sound sound;
  std::string trouble;
  bool is_over = false;
  const auto called = call_plugin([&] {
    (*by)->plugin->receive(order("Speak", {text, ++(*by)->utterances, false}));
    is_over = host.wait(
        [&] { return take(host.take_events(), sound, trouble); }, patience);
  });
  if (!called)
    trouble = called.error().message;
  if (!is_over || !trouble.empty() || sound.empty())
    return fail(ErrorKind::settings,
                "the voice '" + name + "' cannot say \"" + text + "\"" +
                    (trouble.empty() ? "" : ": " + trouble));
  sound = adapters::without_silence(sound);
  const auto loud = adapters::speech_level_of(sound);
  auto& kept = lines_[{name, text}];
  kept = adapters::at_level(std::move(sound), loud, level);
  return &kept;
}

const Sound* SpeechBank::find(const std::string& text,
                              const std::string& voice) const {
  const auto found = lines_.find({voice, text});
  return found == lines_.end() ? nullptr : &found->second;
}

} // namespace parlour::tools
