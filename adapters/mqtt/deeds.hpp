// What DevicePolicy wants done. Whoever drives it carries out the deeds in
// their order.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "runtime/message/message.hpp"

namespace parlour::adapters::mqtt {

// Names a publication until the server has confirmed it; 0: none.
using Ticket = std::uint64_t;

struct Subscribe {
  std::string filter;
};
struct Unsubscribe {
  std::string filter;
};
// Its ticket goes to DevicePolicy::published() once the server has it.
struct Publish {
  Ticket ticket = 0;
  std::string topic;
  std::string payload;
  bool retain = false;
};
// The one answer to a message.
struct Answer {
  Message to;
  std::string command;
  std::vector<Value> params;
};
// An event State that nobody asked for.
struct News {
  std::vector<Value> params;
};
struct Log {
  std::string text;
};

// A test compares them; MQTTDevices carries them out (mqtt_devices.cpp).
using Deed = std::variant<Subscribe, Unsubscribe, Publish, Answer, News, Log>;
using Deeds = std::vector<Deed>;

} // namespace parlour::adapters::mqtt
