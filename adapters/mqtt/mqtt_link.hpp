// MQTTLink keeps a connection to an MQTT server: it connects, notices a loss,
// and connects again after growing pauses.
//
//  pausing     after a loss: the first pause, then twice as long each time, up
//              to a minute. A connection that has held for ten seconds starts
//              the pauses anew
//  looking up  the host's name, on a thread of its own
//  connecting  until the server has accepted the login, or it takes too long
//  up
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include "adapters/loop/alarm.hpp"
#include "adapters/loop/backoff.hpp"
#include "adapters/loop/watch.hpp"
#include "adapters/mqtt/deeds.hpp"
#include "adapters/mqtt/mqtt_client.hpp"
#include "adapters/network/resolver.hpp"

namespace parlour::adapters::mqtt {

// What a link tells. The functions are called on the loop's thread.
// None is called within the constructor, start() or stop().
struct LinkCalls {
  std::function<void()> up;
  // Also after an attempt that failed.
  std::function<void(const std::string& reason)> down;
  std::function<void(Publication publication)> received;
  // The server has the publication with this ticket.
  std::function<void(Ticket ticket)> published;
};

// Used on the loop's thread only (loop.hpp), destroyed like an Alarm.
//
// Subscriptions and publications are not kept over a loss: DevicePolicy says
// them anew when the link is up.
class MQTTLink {
public:
  MQTTLink(Loop& loop, ServerOptions options, LinkCalls calls);
  MQTTLink(const MQTTLink&) = delete;
  MQTTLink& operator=(const MQTTLink&) = delete;
  ~MQTTLink();

  // Connects for the first time.
  void start();
  // Says goodbye and does not connect again. Nothing is told any more.
  void stop();

  // These do nothing unless the link is up; publish() returns whether the
  // publication is on its way.
  void subscribe(const std::string& filter);
  void unsubscribe(const std::string& filter);
  bool publish(const Publish& publication);

private:
  using Moment = Alarm::Moment;
  enum class Phase : std::uint8_t {
    pausing,
    looking_up,
    connecting,
    up,
    stopped
  };

  void attempt();
  void found(const Endpoints& endpoints);
  void connect();
  void ready(short events);
  void rung();
  void tend_later();
  void went_on(const Expected<void>& outcome);
  void hand_over();
  void wait();
  void lose(const std::string& reason);
  void lose_soon(const Expected<void>& outcome);

  Loop& loop_;
  const ServerOptions options_;
  const LinkCalls calls_;
  Phase phase_ = Phase::pausing;
  // Counts the attempts: what was posted for an earlier one is ignored.
  unsigned attempt_ = 0;
  Backoff backoff_;
  Moment up_since_{};
  Moment deadline_ = Moment::max();
  Moment tend_at_ = Moment::max();          // of a link that is up
  std::unordered_map<int, Ticket> tickets_; // by the library's number
  std::unique_ptr<MQTTClient> client_;
  Watch watch_;
  Alarm alarm_;
  int watched_ = -1;
  // The first to go: its threads post to the loop.
  std::optional<Resolver> resolver_;
};

} // namespace parlour::adapters::mqtt
