// MQTTClient is one connection of libmosquitto, version 3.1.1 of the protocol,
// which somebody else drives: it has no thread and never waits, except that the
// library looks up the host's name. It connects once; a new attempt needs a new
// client, so that nothing is left of the last one.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adapters/mqtt/mqtt_options.hpp"
#include "runtime/base/error.hpp"

struct mosquitto;

namespace parlour::adapters::mqtt {

struct Publication {
  std::string topic;
  std::string payload;
  bool retained = false;
};

// Used by one thread, which has SIGPIPE blocked or ignored.
// MQTTLink drives it: it waits for the socket, calls proceed() and tend(), and
// makes another client after a loss.
class MQTTClient {
public:
  explicit MQTTClient(const ServerOptions& options);
  MQTTClient(const MQTTClient&) = delete;
  MQTTClient& operator=(const MQTTClient&) = delete;
  // Closes the connection without a word, so that the server notices a loss.
  ~MQTTClient();

  // An error of kind Settings if the program was built without the library.
  static Expected<void> is_built_in();

  // Each error, of kind Network, says in words why the connection is lost.
  using Outcome = Expected<void>;

  // Begins to connect.
  Outcome connect();
  // Goes on when the socket is ready for poll's `events`, and in any case now
  // and then (`tend`), which also sends what keeps the connection alive.
  Outcome proceed(short events);
  Outcome tend();
  // Tells the server that this is the end, as far as that goes at once.
  void say_goodbye();

  Outcome subscribe(const std::string& filter);
  Outcome unsubscribe(const std::string& filter);
  // The number by which receipts() has it once the server has it.
  Expected<int> publish(const std::string& topic, const std::string& payload,
                        bool retain);

  // -1: there is none.
  int socket() const;
  // The events to wait for: POLLIN, POLLOUT.
  short interest() const;
  // The server has accepted the login.
  bool is_up() const {
    return is_up_;
  }
  // What has come since the last call.
  std::vector<Publication> publications();
  std::vector<int> receipts();

private:
  struct Calls;
  struct Delete {
    void operator()(mosquitto* client) const;
  };

  Outcome prepare();
  Outcome prepare_tls();
  Outcome finish_connecting();
  Outcome judge(int code);
  tl::unexpected<Error> lost(int code) const;

  const ServerOptions options_;
  std::unique_ptr<mosquitto, Delete> client_;
  bool is_connecting_ = false;
  bool is_up_ = false;
  bool is_lost_ = false;
  // What the server answered to the login; 0: nothing, or yes.
  int refusal_ = 0;
  // The library's first words about an error.
  std::string words_;
  std::vector<Publication> publications_;
  std::vector<int> receipts_;
};

} // namespace parlour::adapters::mqtt
