#include "tools/parlour/voice_test/speech_bank.hpp"

#include <algorithm>
#include <span>

#include "tools/parlour/application/plugins/plugin_calls.hpp"
#include "tools/parlour/speech/spoken.hpp"
#include "tools/parlour/voice_test/read_aloud.hpp"

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

// Whether the utterance is over.
bool take(const std::vector<Message>& events, Spoken& spoken) {
  for (const auto& event : events)
    spoken.take(event);
  return spoken.is_over();
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
  Spoken spoken;
  const auto called = call_plugin([&] {
    (*by)->plugin->receive(
        order("Speak", {read_aloud(text), ++(*by)->utterances, false}));
    host.wait([&] { return take(host.take_events(), spoken); }, patience);
  });
  if (!called)
    spoken.trouble = called.error().message;
  if (!spoken.finished || !spoken.trouble.empty() || spoken.samples.empty())
    return fail(ErrorKind::settings,
                "the voice '" + name + "' cannot say \"" + text + "\"" +
                    (spoken.trouble.empty() ? "" : ": " + spoken.trouble));
  auto sound = adapters::without_silence(spoken.samples);
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
