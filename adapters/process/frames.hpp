// Frames: what the two ends of a component's own process say to each other. On
// the wire a frame is the length of what follows (fixed), a byte for its kind,
// and a list of values (runtime/base/bytes.hpp, value_bytes.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

// Both ends are to speak the same.
inline constexpr std::int64_t frame_protocol = 1;

// The closed set: name, fields, a sentence.
// clang-format off
#define PARLOUR_FRAMES(X) \
  X(hello, "protocol, plug-in", "the process is there: the first it says") \
  X(refuse, "error", "the same where it cannot: and its last") \
  X(start, "now, real time?, options, data folder, application folder, " \
           "understanding, phrases?", "call: start the plug-in") \
  X(handle, "now, message", "call: a message for the plug-in") \
  X(run, "now, delay", "call: a delay is over") \
  X(answer, "now, question, error?, message", \
    "call: what another component answered") \
  X(stop, "now", "call: stop the plug-in and end") \
  X(done, "error or what was thrown?", "the call is over") \
  X(fire, "message", "the plug-in fires an event") \
  X(send, "message", "the plug-in sends a message") \
  X(ask, "question, message, milliseconds", \
    "the plug-in asks another component: answer is to come") \
  X(after, "delay, milliseconds", "run is to come after that time") \
  X(cancel, "delay", "it is not") \
  X(log, "text", "a line for the log") \
  X(failed, "reason", "the plug-in says that it is broken") \
  X(column, "question, name", "asks for a column's values") \
  X(phrase, "question, what to say", "asks for words: a rendering") \
  X(reply, "question, error?, value", "the answer to either")
// clang-format on

enum class FrameKind : std::uint8_t {
#define X(name, fields, sentence) name,
  PARLOUR_FRAMES(X)
#undef X
};

std::string_view name_of(FrameKind kind);

struct Frame {
  FrameKind kind = FrameKind::log;
  List fields;

  // Unknown where there are fewer.
  const Value& at(std::size_t position) const;
};

// Longer ones are neither written nor read.
inline constexpr std::size_t longest_frame = 16 << 20;

// An error of kind Limit where it is too long.
Expected<std::string> frame_bytes(const Frame& frame);

// Bytes as they come, to frames. Trusts nothing; holds at most a frame and what
// came with its end.
class FrameReader {
public:
  void add(std::string_view bytes);
  // The next that is whole. An error of kind Network: what comes is none; there
  // is no going on after it.
  Expected<std::optional<Frame>> next();

private:
  std::string held_;
  std::size_t at_ = 0;
};

} // namespace parlour::adapters
