// Converts between the platform's messages and those of agents, parameter by
// parameter (adapters/agents/PROTOCOL.md 1.4).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "adapters/agents/wire/agent_message.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"
#include "runtime/message/message.hpp"

namespace parlour::adapters::agents {

// The text of a value. `json` says whether the receiver reads JSON parameters.
// Bytes are not parameters but a payload; here they become an empty text.
std::string parameter_of(const Value& value, bool json);
// The value of a text. The error says that what follows the mark is not JSON.
Read<Value> value_of(std::string_view parameter, bool json);

// The message for an agent, without a number. A request has a deadline: for how
// long its author waits for the answer. The error, of kind `malformed`, says
// that the message has more than one payload.
Read<AgentMessage> message_for_agent(const Message& message, bool json,
                                     std::optional<Milliseconds> deadline = {});
// The message of an agent for the platform. The caller checks the name of the
// sender (adapters/agents/PROTOCOL.md 3.4).
Read<Message> message_from_agent(const AgentMessage& message, bool json);

} // namespace parlour::adapters::agents
