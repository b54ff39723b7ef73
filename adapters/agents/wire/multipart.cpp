#include "adapters/agents/wire/multipart.hpp"

#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters::agents {
Read<std::vector<std::string>> frames_of(const AgentMessage& message) {
  auto frames = fields_of(message);
  if (!frames)
    return frames;
  frames->emplace(frames->begin(), protocol_frame);
  if (message.payload)
    frames->push_back(message.payload->bytes);
  return frames;
}

Read<AgentMessage> read_frames(std::vector<std::string_view> frames) {
  if (frames.empty() || frames.front() != protocol_frame)
    return tl::make_unexpected(
        WireError{WireErrorKind::version,
                  "the first frame is not " + std::string(protocol_frame)});
  frames.erase(frames.begin());
  if (frames.empty())
    return malformed("the message has no fields");
  // The payload is the last frame. It is taken off first, since it need not be
  // UTF-8.
  std::string_view payload;
  if (is_binary(frames.front()) && frames.size() > 1) {
    payload = frames.back();
    frames.pop_back();
  }
  for (const auto field : frames)
    if (find_invalid_utf8(field))
      return malformed("a field is not UTF-8");
  auto message = message_of(frames, payload.size());
  if (message && message->payload)
    message->payload->bytes = payload;
  return message;
}

} // namespace parlour::adapters::agents
