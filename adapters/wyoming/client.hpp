// Client is what the plug-ins of this folder have in common: their options, a
// loop, and a watch that says whether the server is there.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "adapters/wyoming/server_watch.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::wyoming {

// Options: address, connect-timeout, answer-timeout, pause, one-by-one.
// `port` is that of the service's usual server.
std::vector<OptionDescription> client_options(const std::string& port);

// What the connection of a session tells, on the loop's thread.
// Those of one plug-in, for all of its sessions.
struct SessionCalls {
  std::function<void(const SessionId& session, const Event& event)> received;
  // As that of ConnectionCalls: the last call.
  std::function<void(const SessionId& session, const std::string& reason)>
      closed;
};

// Thread-safe, except where a function says otherwise.
//
// One for each instance of a plug-in. The plug-in's thread posts; everything
// that touches a connection runs on the loop's thread, so that it needs no
// lock.
class Client {
public:
  // How much may be posted and not done yet, in bytes.
  // Two minutes of speech; a loop that is further behind will not catch up.
  static constexpr std::size_t max_posted = 4 << 20;

  // Connects to the server, and calls host.available() as it comes and goes. An
  // error of kind Settings if an option is wrong. The host outlives the client.
  static Expected<std::unique_ptr<Client>>
  start(PluginHost& host, const Options& options,
        const std::vector<OptionDescription>& descriptions,
        const std::string& service);
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client();

  // Has the action done on the loop's thread.
  // From any thread; in the order in which they come.
  void post(Loop::Action action);
  // The same for an action that keeps so many bytes. False: too many wait
  // already, and it is not done.
  bool post(Loop::Action action, std::size_t bytes);
  // The same for what a session says. Where it is not done, `lost` is, as there
  // is a hole now: for each session once, and again when that has been done.
  void post(const SessionId& session, Loop::Action action, std::size_t bytes,
            Loop::Action lost);
  // Has the action done there as the last one, and waits for it. Nothing is
  // done any more after that.
  // Later calls do nothing. The plug-in answers what it owes in `action`.
  void end(Loop::Action action);

  // On the loop's thread.
  const Route& route() const {
    return route_;
  }
  bool is_up() const {
    return watch_->is_up();
  }
  // Begins to connect, and to send audio for what `request` asks. `calls`
  // outlives the connection.
  std::unique_ptr<Connection> connect(const SessionId& session,
                                      const SessionCalls& calls,
                                      const Event& request) const;

  // How long a server may say nothing while an answer is due.
  Milliseconds answer_timeout() const {
    return answer_timeout_;
  }
  // The first pause before another attempt.
  Milliseconds pause() const {
    return pause_;
  }
  bool is_one_by_one() const {
    return one_by_one_;
  }

private:
  Client(std::unique_ptr<Loop> loop, Address address);

  WatchCalls watch_calls(PluginHost& host);

  const std::unique_ptr<Loop> loop_;
  std::atomic<std::size_t> posted_ = 0;
  std::mutex mutex_;
  std::set<SessionId> losing_; // their `lost` is posted
  Resolver resolver_;
  Route route_;
  Milliseconds answer_timeout_{};
  Milliseconds pause_{};
  bool one_by_one_ = false;
  bool is_ended_ = false;
  std::unique_ptr<ServerWatch> watch_;
  // Used on the loop's thread.
  std::string reason_; // that was logged last
};

} // namespace parlour::adapters::wyoming
