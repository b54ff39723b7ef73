// Which addresses of ZeroMQ cannot be reached from other hosts.
#pragma once

#include <string_view>

namespace parlour::adapters::agents {

// "tcp://127.0.0.1:5672" and "ipc:///run/taps" are local, "tcp://*:5672" is
// not.
bool is_local_address(std::string_view address);

} // namespace parlour::adapters::agents
