// Writes and reads messages as the frames of a multipart message, the form that
// they have on a ZeroMQ connection (adapters/agents/PROTOCOL.md 2.3). Frames
// are neither quoted nor escaped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "adapters/agents/wire/agent_message.hpp"

namespace parlour::adapters::agents {

// The first frame of every message.
inline constexpr std::string_view protocol_frame = "parlour/1";

// The frames of a message. Errors as those of fields_of().
Read<std::vector<std::string>> frames_of(const AgentMessage& message);

// The message of the frames, which are not trusted. The error has the kind
// `version` if the first frame names another protocol.
Read<AgentMessage> read_frames(std::vector<std::string_view> frames);

} // namespace parlour::adapters::agents
