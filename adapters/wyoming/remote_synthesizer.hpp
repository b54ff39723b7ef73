// A Wyoming server as a Synthesizer. It works on the engine's thread and waits
// there for the client's loop.
#pragma once

#include <memory>
#include <string>

#include "adapters/tts/synthesizer.hpp"
#include "adapters/wyoming/client.hpp"

namespace parlour::adapters::wyoming {

// The client must outlive it.
// Makes no connection yet: each piece of text has one of its own.
Expected<std::unique_ptr<tts::Synthesizer>>
make_remote_synthesizer(Client& client, const std::string& language);

} // namespace parlour::adapters::wyoming
