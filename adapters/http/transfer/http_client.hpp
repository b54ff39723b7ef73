// HttpClient carries requests out: with their tries, redirects and pauses
// (policy/exchange), as many at once as are allowed, and not at all while a
// service is out (policy/circuit_breaker). It has one thread, a Loop of its
// own.
#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "adapters/http/policy/circuit_breaker.hpp"
#include "adapters/http/policy/exchange.hpp"
#include "adapters/http/transfer/transfers.hpp"
#include "adapters/loop/alarm.hpp"
#include "runtime/base/random.hpp"

namespace parlour::adapters::http {

struct ClientOptions {
  TransferOptions transfer;
  Exchange::Terms exchange;
  CircuitBreaker::Terms breaker;
  // For all tries of a request that does not say it itself.
  Milliseconds timeout{8'000};
  // How many transfers may run at once, and how many requests may wait beside
  // them.
  std::size_t connections = 8;
  std::size_t queue = 100;
};

// A submitted request may have to wait for its own pause (not_before) and for a
// free connection; the breaker of its server refuses it at once.
class HttpClient {
public:
  // Called once, on the client's thread, or on the caller's if too many wait.
  using Done = std::function<void(TryOutcome)>;
  // How transfers are made.
  using Open = std::function<Expected<std::unique_ptr<Transfers>>(
      Loop&, TransferOptions)>;

  // `thrown` gets what a Done throws, on the client's thread. The error says
  // that no thread can be started or that there is no libcurl.
  static Expected<std::unique_ptr<HttpClient>>
  start(ClientOptions options, Loop::Thrown thrown,
        const Open& open = curl_transfers);
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;
  // Cancels what runs and waits, and tells each that the component ends.
  ~HttpClient();

  // Thread-safe; never blocks. Its time begins now.
  void submit(HttpRequest request, Done done);

private:
  using Moment = Exchange::Moment;

  // A request that is not done yet.
  struct Order {
    Exchange exchange;
    Done done;
    // Of whom the breaker keeps account: redirects do not change it.
    std::string server;
    // When it may be sent again; it waits if the moment has passed.
    Moment not_before{};
    std::optional<Transfers::Id> running = {};
    CircuitBreaker::Pass pass = {};
  };
  using Place = std::list<Order>::iterator;

  HttpClient(ClientOptions options, std::unique_ptr<Loop> loop);

  // On the client's thread.
  void add(HttpRequest request, Done done, Moment deadline);
  void turn();
  void start_what_may(Moment now);
  bool start_one(Place order, Moment now);
  void wait(Moment now);
  void took_place(Place order, TryOutcome outcome);
  void note(const Order& order, const TryOutcome& outcome, Moment now);
  void finish(Place order, TryOutcome outcome);
  CircuitBreaker& breaker(const std::string& server);
  void end();

  const ClientOptions options_;
  std::mutex mutex_;
  std::size_t pending_ = 0; // guarded: requests that are not done
  const std::unique_ptr<Loop> loop_;

  // Used on the loop's thread only.
  std::unique_ptr<Transfers> transfers_;
  Alarm alarm_;
  std::list<Order> orders_;
  std::map<std::string, CircuitBreaker> breakers_;
  std::size_t running_ = 0;
  Random random_;
  bool is_over_ = false;
};

} // namespace parlour::adapters::http
