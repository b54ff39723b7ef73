// A voice and a recogniser for tests of conversations by voice: the voice hums,
// and the recogniser hears what it is told.
#pragma once

#include <cmath>
#include <deque>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include "adapters/audio/mixing.hpp"
#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/catalogue.hpp"

namespace parlour::test {

// 250 ms for each letter, and silence around them.
inline adapters::Sound humming(const std::string& text) {
  adapters::Sound sound(adapters::samples_in(100));
  const auto length = adapters::samples_in(250) * text.size();
  for (std::size_t i = 0; i < length; ++i) {
    const auto time = static_cast<double>(i) / adapters::speech_rate;
    const auto turn = 2 * std::numbers::pi * time;
    sound.push_back(static_cast<adapters::Sample>(
        4'000 * std::sin(turn * 300) * (0.6 + 0.4 * std::sin(turn * 4))));
  }
  sound.resize(sound.size() + adapters::samples_in(100));
  return sound;
}

// Has the voices "rms" and "slt"; cannot say "unspeakable", and throws at
// "unbearable".
class HummingTTS : public TTSPlugin {
protected:
  Expected<void> on_start(const Options& options) override {
    const auto voice = options.find("voice");
    if (voice != options.end() && voice->second != "rms" &&
        voice->second != "slt")
      return fail(ErrorKind::settings, "no such voice");
    return {};
  }
  void on_speak(const std::string& text, Utterance utterance,
                std::optional<bool>) override {
    if (text == "unspeakable")
      return refuse("too hard");
    if (text == "unbearable")
      throw std::runtime_error("too much");
    const auto sound = humming(text);
    const std::span<const adapters::Sample> samples(sound);
    for (std::size_t at = 0; at < samples.size();
         at += adapters::frame_samples) {
      const auto rest = samples.subspan(at);
      const auto value = adapters::pcm_value(
          rest.first(std::min(adapters::frame_samples, rest.size())));
      fire_audio(*value.if_binary(), utterance);
    }
    fire_finished(utterance);
  }
  void on_stop(std::optional<Utterance>) override {}
};

inline PluginFactory humming_tts() {
  PluginDescription description;
  description.name = "HummingTTS";
  description.roles = {"TTS"};
  description.sentence = "hums";
  return {description, [] { return std::make_unique<HummingTTS>(); }};
}

// Has HummingTTS in the place of flite.
class HummingVoices : public PluginCatalogue {
public:
  Expected<PluginFactory> find(const std::string& name) override {
    if (name == "FliteTTS")
      return humming_tts();
    return fail(ErrorKind::settings, "no plug-in " + name);
  }
  std::vector<PluginDescription> all() override {
    return {};
  }
};

using Hearings = std::shared_ptr<std::deque<std::string>>;

// Hears the next text at the end of each utterance; rejects "".
class ToldASR : public ASRPlugin {
public:
  explicit ToldASR(Hearings texts) : texts_(std::move(texts)) {}

protected:
  void on_do_recognition(const Binary&) override {}
  void on_finish() override {
    if (texts_->empty() || texts_->front().empty())
      fire_rejected("nothing");
    else
      fire_result(texts_->front(), 1);
    if (!texts_->empty())
      texts_->pop_front();
  }
  void on_cancel() override {}

private:
  Hearings texts_;
};

inline PluginFactory told_asr(Hearings texts) {
  PluginDescription description;
  description.name = "ToldASR";
  description.roles = {"ASR"};
  description.sentence = "hears what it is told";
  return {description, [texts] { return std::make_unique<ToldASR>(texts); }};
}

} // namespace parlour::test
