// What is said between MoonshineASR or SileroVAD and their program, as bytes
// (tools/agents/moonshine/README.md). The program is not trusted: whatever it
// says is checked.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/audio/pcm.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters::moonshine {

// Names a turn of some conversation; never used again.
using TurnNumber = std::int64_t;

// What an application says and hears.
struct Words {
  std::vector<std::string> phrases;
  // So many of them, the first ones, are names and other values.
  std::size_t names = 0;
};

// For the program.
std::string audio_frame(TurnNumber turn, std::span<const Sample> samples);
// Of a stream in which speech is to be found.
std::string detect_frame(TurnNumber stream, std::span<const Sample> samples);
// Before its audio: the only words that the turn is to prefer.
std::string narrow_frame(TurnNumber turn, const Words& words);
// A result or a rejection follows; after `cancel` nothing does.
std::string finish_frame(TurnNumber turn);
std::string cancel_frame(TurnNumber turn);
// Its domain model, in as many frames as it needs.
// `rejects`: speech that it finds too unlikely is no turn.
std::vector<std::string> language_frames(std::string_view model,
                                         bool rejects = true);
// The words of the application; those that do not fit into a frame are left
// out, the last ones first.
std::string words_frame(const Words& words);

// What the program says.
enum class AnswerKind : std::uint8_t {
  ready,    // the model is loaded
  partial,  // what was said so far
  result,   // what was said
  rejected, // nothing was said
  speech,   // how likely a stream is speech
  failed    // the program cannot go on
};

// Which fields count depends on the kind; the others are empty.
struct Answer {
  AnswerKind kind = AnswerKind::failed;
  TurnNumber turn = 0;
  // Of `rejected` and `failed`: the reason.
  std::string text;
  double confidence = 0; // 0 to 1
  // Maps with `text` and `confidence`.
  List alternatives;
  List words;
  // Of `speech`: of each piece, 0 to 1.
  std::vector<double> likely;
};

// Splits the bytes of the program into its answers. It holds at most one
// incomplete line and the bytes of the last add().
// For one stream, on one thread.
class AnswerReader {
public:
  // In bytes.
  static constexpr std::size_t longest_line = 256 << 10;

  void add(std::string_view bytes);
  // The next complete answer, or nothing. After an error, of kind Network, the
  // stream cannot be read further.
  Expected<std::optional<Answer>> next();

private:
  std::string held_;
  std::size_t at_ = 0;
};

} // namespace parlour::adapters::moonshine
