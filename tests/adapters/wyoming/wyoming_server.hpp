// A Wyoming server of the tests' own, on a port that the system chooses. What
// it does with a connection is a function, on a thread of its own: it may
// behave or not.
#pragma once

#include <any>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "adapters/wyoming/event.hpp"
#include "runtime/plugin/options.hpp"

namespace parlour::test {

class WyomingServer {
public:
  // One connection, for its thread.
  class Peer {
  public:
    explicit Peer(int socket) : socket_(socket) {}
    // The next event; nothing once the client has gone.
    std::optional<adapters::wyoming::Event> read();
    // Whether all of it could be sent.
    bool write(const std::string& bytes) const;
    bool send(const adapters::wyoming::Event& event) const;
    // Until the client has gone.
    void wait_for_end();
    // The same for one that takes nothing of what the client sends.
    void stall() const;
    // What the server keeps for this connection: the one place that its thread
    // shares with no other.
    template <class T>
    T& own() {
      if (!own_.has_value())
        own_ = T{};
      return std::any_cast<T&>(own_);
    }

  private:
    int socket_;
    adapters::wyoming::EventReader reader_;
    std::vector<adapters::wyoming::Event> waiting_;
    std::any own_;
  };
  // Serves an event; false ends the connection.
  using Serve =
      std::function<bool(Peer& peer, const adapters::wyoming::Event& event)>;

  // Answers `describe` as one that offers the service, and leaves all else to
  // `serve`. Port 0: any.
  explicit WyomingServer(std::string service, Serve serve, int port = 0);
  WyomingServer(const WyomingServer&) = delete;
  WyomingServer& operator=(const WyomingServer&) = delete;
  // Cuts all connections.
  ~WyomingServer();

  int port() const;
  // Options of a plug-in that uses it, with short times.
  Options options() const;
  // Until so many connections have come in all.
  void wait_for_connections(int count) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace parlour::test
