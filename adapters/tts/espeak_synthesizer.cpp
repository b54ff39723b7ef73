// libespeak-ng as a Synthesizer. It speaks within espeak_Synth() and hands over
// samples by a callback; all of its state is global.
#include "adapters/tts/espeak_synthesizer.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <optional>

#include <espeak-ng/speak_lib.h>

namespace parlour::adapters::tts {

namespace {

constexpr int buffer_time = 20; // ms

// The piece that is being spoken.
struct Piece {
  SpeechSink* sink;
  // Where each word begins, in characters from 1.
  std::vector<int> beginnings;
  int rate;
};

// The callback has no other way to know it.
Piece* spoken = nullptr;

std::vector<int> beginnings_of(const Words& words) {
  std::vector<int> beginnings;
  int at = 1;
  for (const auto& word : words) {
    beginnings.push_back(at);
    at += static_cast<int>(count_characters(word)) + 1;
  }
  return beginnings;
}

// Events without a length say where a pause is.
void tell_words(const espeak_EVENT* event) {
  for (; event->type != espeakEVENT_LIST_TERMINATED; ++event) {
    if (event->type != espeakEVENT_WORD || event->length <= 0)
      continue;
    const auto behind =
        std::ranges::upper_bound(spoken->beginnings, event->text_position);
    if (behind != spoken->beginnings.begin())
      spoken->sink->word(
          static_cast<std::size_t>(behind - spoken->beginnings.begin()) - 1,
          event->audio_position);
  }
}

// Returns 1 to end the synthesis.
int take(short* samples, int count, espeak_EVENT* events) {
  if (!spoken)
    return 1;
  tell_words(events);
  if (!samples || count <= 0)
    return 0;
  const std::span sound(samples, static_cast<std::size_t>(count));
  return spoken->sink->sound(sound, spoken->rate) ? 0 : 1;
}

// "en+f3" for "en-gb+f3"; empty if nobody speaks the language.
std::string named_by_language(const std::string& voice) {
  const auto plus = std::min(voice.find('+'), voice.size());
  const auto language = voice.substr(0, plus);
  const auto* const* known = espeak_ListVoices(nullptr);
  // The first byte of a list of languages is a priority.
  for (; known && *known; ++known)
    if ((*known)->languages && (*known)->languages[0] &&
        language == (*known)->languages + 1)
      return std::filesystem::path((*known)->identifier).filename().string() +
             voice.substr(plus);
  return "";
}

class EspeakSynthesizer : public Synthesizer {
public:
  explicit EspeakSynthesizer(int rate) : rate_(rate) {}

  // A hundred times faster than speech: longer pieces sound better.
  PieceLength piece_length() const override {
    return {.wanted = 200, .longest = 500};
  }

  Expected<void> check_voice(const std::string& voice) override {
    settings_.reset();
    return set_voice(voice);
  }

  Expected<void> speak(const Words& words, bool is_last,
                       const VoiceSettings& settings,
                       SpeechSink& sink) override {
    if (auto set = apply(settings); !set)
      return set;
    const auto text = joined(words);
    Piece piece{&sink, beginnings_of(words), rate_};
    spoken = &piece;
    // Without espeakSSML and espeakPHONEMES no character has a meaning.
    const auto flags = static_cast<unsigned>(espeakCHARS_UTF8 |
                                             (is_last ? 0 : espeakENDPAUSE));
    const auto outcome =
        espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0, flags,
                     nullptr, nullptr);
    spoken = nullptr;
    if (outcome != EE_OK)
      return fail(ErrorKind::limit, "espeak-ng cannot speak this text");
    return {};
  }

private:
  // The library would open a file of that name.
  static bool is_name(const std::string& voice) {
    return !voice.empty() && voice.size() <= 40 &&
           std::ranges::all_of(voice, [](unsigned char c) {
             return std::isalnum(c) || std::strchr("-_+", c);
           });
  }

  // The library knows en-us by its name, and en-gb only as a language.
  static Expected<void> set_voice(const std::string& voice) {
    if (is_name(voice) &&
        (espeak_SetVoiceByName(voice.c_str()) == EE_OK ||
         espeak_SetVoiceByName(named_by_language(voice).c_str()) == EE_OK))
      return {};
    return fail(ErrorKind::settings,
                "espeak-ng has no voice '" + voice +
                    "'; there are en-us, en-gb, de, fr-fr and what "
                    "`espeak-ng --voices` lists, each also with a variant, "
                    "such as en-us+f3");
  }

  Expected<void> apply(const VoiceSettings& settings) {
    if (settings_ == settings)
      return {};
    if (auto set = set_voice(settings.voice); !set)
      return set;
    espeak_SetParameter(espeakRATE, settings.rate, 0);
    espeak_SetParameter(espeakPITCH, settings.pitch, 0);
    espeak_SetParameter(espeakVOLUME, settings.volume, 0);
    settings_ = settings;
    return {};
  }

  const int rate_;                        // samples a second
  std::optional<VoiceSettings> settings_; // that are in effect
};

} // namespace

// The library starts once and never ends: espeak_Terminate() waits forever the
// second time (1.51). Only one engine is made at a time.
Expected<std::unique_ptr<Synthesizer>> make_espeak_synthesizer() {
  static int rate = 0;
  if (rate <= 0) {
    rate = espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, buffer_time, nullptr,
                             espeakINITIALIZE_DONT_EXIT);
    espeak_SetSynthCallback(take);
  }
  if (rate <= 0)
    return fail(ErrorKind::settings,
                "the data of espeak-ng are missing; install espeak-ng-data");
  return std::make_unique<EspeakSynthesizer>(rate);
}

} // namespace parlour::adapters::tts
