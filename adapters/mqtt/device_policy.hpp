// DevicePolicy decides what MQTTDevices does, and does none of it: what is
// subscribed to, what is published for an application's orders, what devices'
// messages mean, and what becomes of requests. It has no thread, no socket and
// no clock: it is told what happens and when, and returns deeds.
//
//  starting   requests are held
//  connected  requests are held until devices have announced themselves: until
//             there was no announcement for a while, but no longer than 5 s
//  down       requests fail
#pragma once

#include <cstdint>
#include <string>

#include "adapters/mqtt/complaints.hpp"
#include "adapters/mqtt/deeds.hpp"
#include "adapters/mqtt/device_list.hpp"
#include "adapters/mqtt/device_requests.hpp"
#include "adapters/mqtt/device_table.hpp"
#include "runtime/base/limited_log.hpp"
#include "runtime/base/rate_limit.hpp"

namespace parlour::adapters::mqtt {

// From the options of the plug-in; docs/devices.md explains them.
struct PolicySettings {
  // The first part of the topics on which devices announce themselves.
  std::string prefix = "homeassistant";
  // How long a request may take.
  Milliseconds patience{5'000};
  // Nobody announces anything for so long: all have done it.
  Milliseconds settle{500};
};

// Call deeds() after each call that may lead to some, carry them out, and call
// decide() at next_moment().
// Not thread-safe. Every message gets exactly one answer.
class DevicePolicy {
public:
  // The longest message of a device that is read, in bytes.
  static constexpr std::size_t max_payload = 262'144;
  // How many events may be told at once, and in a second. More would make the
  // platform think that the component has lost its mind (docs/components.md).
  static constexpr unsigned most_news = 200;
  static constexpr unsigned news_in_a_second = 100;

  DevicePolicy(PolicySettings settings, DeviceList list);
  DevicePolicy(const DevicePolicy&) = delete;
  DevicePolicy& operator=(const DevicePolicy&) = delete;

  // -- what happens -----------------------------------------------------------

  void connected(Moment now);
  void disconnected(const std::string& reason);
  // `retained`: it is not new, the server had kept it.
  void received(const std::string& topic, std::string payload, bool retained,
                Moment now);
  void published(Ticket ticket, Moment now);
  void not_published(Ticket ticket);
  // A message of a conversation: Set or Ask.
  void order(const Message& message, Moment now);
  // Call it at next_moment().
  void decide(Moment now);
  // Answers every request.
  void end();

  // -- what follows -----------------------------------------------------------

  Deeds deeds();
  // max() for never.
  Moment next_moment() const;
  std::uint64_t count(Complaint kind) const {
    return complaints_.count(kind);
  }

private:
  enum class Link : std::uint8_t { starting, connected, down };

  void announced(const std::string& topic, const std::string& kind,
                 const Payload& payload, Moment now);
  void read_state(Device& device, const Payload& payload, bool retained,
                  Moment now);
  static void read_availability(Device& device, const std::string& topic,
                                const Payload& payload);
  // Makes a News of its state, if the application speaks of the device.
  void tell(const Device& device, Moment now);
  void follow_table();
  // Whether all devices count as announced, so that requests may begin.
  bool is_settled(Moment now) const;
  void complain(Complaint kind, const std::string& text, Moment now);

  const PolicySettings settings_;
  const DeviceList list_;
  Deeds deeds_;
  DeviceTable table_;
  DeviceRequests requests_;
  LimitedLog<Complaint> complaints_{one_complaint_in};

  Link link_ = Link::starting;
  std::string reason_; // why it is down
  Moment connected_at_{};
  Moment settled_at_ = Moment::max();
  // It was logged how many devices there are.
  bool has_counted_ = false;
  // How many events may be told now, and since when that is so.
  RateLimit news_{news_in_a_second, most_news};
};

} // namespace parlour::adapters::mqtt
