// flite as a Synthesizer. It hands over samples by a callback, after all else
// of the piece is known: so all words are told first.
#include "adapters/tts/flite_synthesizer.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <flite/flite.h>

#include "adapters/tts/plain_words.hpp"

extern "C" {
cst_voice* register_cmu_us_slt(const char*);
cst_voice* register_cmu_us_rms(const char*);
cst_voice* register_cmu_us_awb(const char*);
cst_voice* register_cmu_us_kal16(const char*);
}

namespace parlour::adapters::tts {

namespace {

constexpr int own_rate = 175;        // words a minute, as the voices speak
constexpr int own_pitch = 50;        // as options count it
constexpr float own_tone = 120;      // Hz, of kal16
constexpr float tone_step = 1.5;     // Hz for each step of the option
constexpr int smallest_buffer = 320; // samples

struct KnownVoice {
  const char* name;
  cst_voice* (*load)(const char*);
};
constexpr std::array<KnownVoice, 4> known_voices = {
    {{"slt", register_cmu_us_slt},
     {"rms", register_cmu_us_rms},
     {"awb", register_cmu_us_awb},
     {"kal16", register_cmu_us_kal16}}};

// The piece as flite gets it: words may be left out.
struct Piece {
  std::string text;
  std::vector<std::size_t> words; // their indices
  SpeechSink* sink;
  int volume; // percent
  bool are_told = false;
  std::vector<Sample> louder;
};

Piece piece_of(const Words& words, SpeechSink& sink, int volume) {
  Piece piece{{}, {}, &sink, volume, false, {}};
  for (std::size_t i = 0; i < words.size(); ++i)
    if (const auto plain = in_plain_letters(words[i]); !plain.empty()) {
      piece.text += (piece.text.empty() ? "" : " ") + plain;
      piece.words.push_back(i);
    }
  return piece;
}

// Where the first sound of a token begins, in ms; -1: it has none.
std::int64_t beginning(const cst_item* token) {
  for (auto* word = item_daughter(token); word; word = item_next(word)) {
    const auto* sound =
        path_to_item(word, "R:SylStructure.daughter1.daughter1.R:Segment");
    if (sound)
      return item_prev(sound)
                 ? static_cast<std::int64_t>(
                       item_feat_float(item_prev(sound), "end") * 1'000)
                 : 0;
  }
  return -1;
}

// A token behind a blank begins the next word of the text.
void tell_words(Piece& piece, const cst_utterance* utterance) {
  // The library reads through pointers that could be written through.
  auto* readable = const_cast<cst_utterance*>(utterance);
  piece.are_told = true;
  std::size_t behind = 0; // how many words have begun
  auto* token = relation_head(utt_relation(readable, "Token"));
  for (; token; token = item_next(token)) {
    const bool begins =
        behind == 0 || *get_param_string(item_feats(token), "whitespace", "");
    behind += begins;
    const auto position = beginning(token);
    if (position >= 0 && behind <= piece.words.size())
      piece.sink->word(piece.words[behind - 1], position);
  }
}

std::span<const Sample> with_volume(Piece& piece,
                                    std::span<const Sample> samples) {
  if (piece.volume == 100)
    return samples;
  piece.louder.clear();
  for (const auto sample : samples)
    piece.louder.push_back(static_cast<Sample>(
        std::clamp(sample * piece.volume / 100, -32'768, 32'767)));
  return piece.louder;
}

int take(const cst_wave* wave, int start, int size, int,
         cst_audio_streaming_info* streaming) {
  auto& piece = *static_cast<Piece*>(streaming->userdata);
  if (!piece.are_told)
    tell_words(piece, streaming->utt);
  const std::span sound(wave->samples + start, static_cast<std::size_t>(size));
  return piece.sink->sound(with_volume(piece, sound), wave->sample_rate)
             ? CST_AUDIO_STREAM_CONT
             : CST_AUDIO_STREAM_STOP;
}

class FliteSynthesizer : public Synthesizer {
public:
  // The first sound of a piece takes as long as its length makes it.
  PieceLength piece_length() const override {
    return {.wanted = 30, .longest = 200};
  }

  Expected<void> check_voice(const std::string& voice) override {
    return find(voice).map([](const cst_voice*) {});
  }

  // Its pieces end with a pause.
  Expected<void> speak(const Words& words, bool, const VoiceSettings& settings,
                       SpeechSink& sink) override {
    const auto voice = find(settings.voice);
    if (!voice)
      return tl::make_unexpected(voice.error());
    auto piece = piece_of(words, sink, settings.volume);
    if (piece.text.empty())
      return {};
    set_features(**voice, settings, piece);
    auto* utterance = flite_synth_text(piece.text.c_str(), *voice);
    if (!utterance)
      return fail(ErrorKind::limit, "flite cannot speak this text");
    delete_utterance(utterance);
    return {};
  }

private:
  static void set_features(cst_voice& voice, const VoiceSettings& settings,
                           Piece& piece) {
    const auto pitch = static_cast<float>(settings.pitch - own_pitch);
    feat_set_float(voice.features, "duration_stretch",
                   static_cast<float>(own_rate) /
                       static_cast<float>(settings.rate));
    feat_set_float(voice.features, "f0_shift", 1 + pitch / 100);
    if (voice.name == std::string("kal16"))
      feat_set_float(voice.features, "int_f0_target_mean",
                     own_tone + pitch * tone_step);
    auto* streaming = new_audio_streaming_info();
    streaming->asc = take;
    streaming->min_buffsize = smallest_buffer;
    streaming->userdata = &piece;
    // The voice owns it, and deletes it when the next one is set.
    feat_set(voice.features, "streaming_info",
             audio_streaming_info_val(streaming));
  }

  // Voices are loaded when they are first wanted, and stay: they are global.
  static Expected<cst_voice*> find(const std::string& name) {
    static const bool started = flite_init() == 0;
    for (const auto& known : known_voices)
      if (started && name == known.name)
        return known.load(nullptr);
    return fail(ErrorKind::settings, "flite has no voice '" + name +
                                         "'; there are slt, rms, awb and "
                                         "kal16");
  }
};

} // namespace

Expected<std::unique_ptr<Synthesizer>> make_flite_synthesizer() {
  return std::make_unique<FliteSynthesizer>();
}

} // namespace parlour::adapters::tts
