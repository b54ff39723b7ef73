// Any bytes as what an MQTT server sends, line by line: "topic<tab>payload".
// The policy of MQTTDevices must bear it, and answer each order once.
#include <cstdlib>
#include <string>
#include <string_view>

#include "adapters/mqtt/device_policy.hpp"

namespace {

using namespace parlour;
using namespace parlour::adapters::mqtt;

DeviceList list() {
  DeviceList made;
  made.devices.push_back({"lamp", "*", "light", "", {}, {}});
  made.devices.back().device_words = {"lamp"};
  return made;
}

// What the policy wants done is counted, and the server confirms everything.
std::size_t carry_out(DevicePolicy& policy, Moment now) {
  std::size_t answers = 0;
  for (auto deeds = policy.deeds(); !deeds.empty(); deeds = policy.deeds())
    for (const auto& deed : deeds) {
      answers += std::holds_alternative<Answer>(deed) ? 1 : 0;
      if (const auto* publication = std::get_if<Publish>(&deed))
        policy.published(publication->ticket, now);
    }
  return answers;
}

Message order(std::string_view text) {
  Message made;
  made.command = text.size() % 2 == 0 ? "Set" : "Ask";
  const auto slash = std::min(text.find('/'), text.size());
  made.params = {text.substr(0, slash), text.substr(slash), "on"};
  return made;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  DevicePolicy policy({"ha"}, list());
  Moment now{};
  std::size_t orders = 0;
  std::size_t answers = 0;
  policy.connected(now);
  while (!rest.empty()) {
    const auto line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const auto tab = std::min(line.find('\t'), line.size());
    now += Milliseconds(100);
    if (tab == line.size()) {
      policy.order(order(line), now);
      ++orders;
    } else {
      policy.received(std::string(line.substr(0, tab)),
                      std::string(line.substr(tab + 1)), tab % 2 == 0, now);
    }
    policy.decide(now);
    answers += carry_out(policy, now);
  }
  policy.end();
  answers += carry_out(policy, now);
  if (answers != orders)
    std::abort();
  return 0;
}
