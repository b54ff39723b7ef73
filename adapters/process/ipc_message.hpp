// The protocol between the platform and a component's process. An IpcMessage is
// one message of it. On the wire a message is
//
//  8 bytes   the length of the rest
//  1 byte    its kind
//  …         a list of values (runtime/base/value_bytes.hpp)
//
// Whichever side reads trusts nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

// The version of the protocol, which `hello` tells. Both sides must have the
// same.
inline constexpr std::int64_t ipc_protocol = 4;

// The kinds: name, fields, a sentence. A field with `?` may be unknown.
// clang-format off
#define PARLOUR_IPC_MESSAGES(X) \
  X(hello, "protocol, plug-in", "the process is there: the first it says") \
  X(refuse, "error", "the same where it cannot: and its last") \
  X(start, "now, real time?, options, data folder, application folder", \
    "call: start the plug-in") \
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
  X(available, "yes or no", "whether the plug-in can take messages now") \
  X(column, "question, name", "asks for a column's values") \
  X(language, "question", \
    "asks what the scripts say: understanding, phrases?") \
  X(phrase, "question, what to say", "asks for words: a rendering") \
  X(reply, "question, error?, value", "the answer to these three")
// clang-format on

enum class IpcKind : std::uint8_t {
#define X(name, fields, sentence) name,
  PARLOUR_IPC_MESSAGES(X)
#undef X
};

std::string_view name_of(IpcKind kind);

struct IpcMessage {
  IpcKind kind = IpcKind::log;
  List fields;

  // The field at a position, or unknown if there are fewer.
  const Value& at(std::size_t position) const;
};

// Longer messages are neither written nor read, so that neither side can
// exhaust the memory of the other.
inline constexpr std::size_t longest_ipc_message = 16 << 20;

// The message as bytes. The error, of kind Limit, says that it is too long.
Expected<std::string> ipc_bytes(const IpcMessage& message);

// Splits the bytes of a stream into messages. The bytes are not trusted:
// lengths, kinds and values are checked. It holds at most one incomplete
// message and the bytes of the last add().
class IpcReader {
public:
  void add(std::string_view bytes);
  // The next complete message, or nothing. After an error, of kind Network, the
  // stream cannot be read further.
  Expected<std::optional<IpcMessage>> next();

private:
  std::string held_;
  std::size_t at_ = 0;
};

} // namespace parlour::adapters
