// The examples of adapters/agents/vectors/, which the agents in other languages
// run, too.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "adapters/agents/wire/agent_message.hpp"

namespace parlour::adapters::agents {

const nlohmann::json& vectors();

// The message that an example describes.
AgentMessage message_in(const nlohmann::json& described);

// The bytes of an example's line, with its end.
std::string line_in(const nlohmann::json& example);

} // namespace parlour::adapters::agents
