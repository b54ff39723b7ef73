#include "adapters/http/transfer/http_client.hpp"

#include <algorithm>
#include <future>
#include <random>
#include <utility>

#include "adapters/http/message/http_address.hpp"

namespace parlour::adapters::http {

namespace {

using Steady = std::chrono::steady_clock;
using Kind = HttpFailure::Kind;

TryOutcome refused(std::string reason) {
  return tl::make_unexpected(
      HttpFailure{Kind::refused, std::move(reason), false});
}

std::string server_of(const std::string& address) {
  const auto read = read_address(address);
  return read ? read->server() : "";
}

} // namespace

// Waits for the loop's thread once, so that an error is one of the start.
Expected<std::unique_ptr<HttpClient>> HttpClient::start(ClientOptions options,
                                                        Loop::Thrown thrown,
                                                        const Open& open) {
  auto loop = Loop::start(std::move(thrown));
  if (!loop)
    return tl::make_unexpected(loop.error());
  auto& thread = **loop;
  std::unique_ptr<HttpClient> client(
      new HttpClient(std::move(options), std::move(*loop)));
  // Transfers are used on the loop's thread only, from their beginning.
  std::promise<Expected<void>> opened;
  thread.post([&] {
    auto transfers = open(thread, client->options_.transfer);
    if (transfers)
      client->transfers_ = std::move(*transfers);
    opened.set_value(transfers.map([](const auto&) {}));
  });
  if (auto ready = opened.get_future().get(); !ready)
    return tl::make_unexpected(ready.error());
  return client;
}

HttpClient::HttpClient(ClientOptions options, std::unique_ptr<Loop> loop)
    : options_(std::move(options)), loop_(std::move(loop)),
      alarm_(*loop_, [this] { turn(); }), random_(std::random_device()()) {}

HttpClient::~HttpClient() {
  loop_->post([this] { end(); });
  loop_->stop();
}

// Counted here and not on the loop's thread, which may be behind: the bound
// holds at once.
void HttpClient::submit(HttpRequest request, Done done) {
  const auto most = options_.connections + options_.queue;
  const auto timeout = request.timeout > Milliseconds::zero()
                           ? request.timeout
                           : options_.timeout;
  {
    const std::lock_guard lock(mutex_);
    if (pending_ < most) {
      ++pending_;
      loop_->post([this, request = std::move(request), done = std::move(done),
                   deadline = Steady::now() + timeout]() mutable {
        add(std::move(request), std::move(done), deadline);
      });
      return;
    }
  }
  done(refused("is not asked, as " + std::to_string(most) +
               " requests wait already"));
}

// -- on the client's thread ---------------------------------------------------

void HttpClient::add(HttpRequest request, Done done, Moment deadline) {
  auto server = server_of(request.address);
  orders_.push_back({Exchange(std::move(request), options_.exchange, deadline),
                     std::move(done), std::move(server)});
  turn();
}

void HttpClient::turn() {
  if (is_over_)
    return;
  start_what_may(Steady::now());
  wait(Steady::now());
}

// In the order in which they have come. An order that ends is erased, so the
// next one is found first.
//
// An order is running, waits for its pause, waits for a connection, or is over
// because its time is.
void HttpClient::start_what_may(Moment now) {
  for (auto next = orders_.begin(); next != orders_.end();) {
    const auto order = next++;
    if (order->running)
      continue;
    if (now >= order->exchange.deadline())
      finish(order, refused("was not asked in time, as other requests are "
                            "under way"));
    else if (running_ < options_.connections && now >= order->not_before &&
             !start_one(order, now))
      finish(order, refused(breaker(order->server).refusal(now)));
  }
}

// False if the breaker refuses it.
bool HttpClient::start_one(Place order, Moment now) {
  const auto pass = breaker(order->server).admit(now);
  if (!pass)
    return false;
  order->pass = *pass;
  ++running_;
  order->running = transfers_->start(order->exchange.request(),
                                     order->exchange.remaining(now),
                                     [this, order](TryOutcome outcome) {
                                       took_place(order, std::move(outcome));
                                     });
  return true;
}

// Until an order's pause or time is over. While all connections are in use, the
// end of a transfer begins the next turn, so pauses need no alarm.
void HttpClient::wait(Moment now) {
  auto moment = Alarm::never;
  for (const auto& order : orders_) {
    if (order.running)
      continue;
    moment = std::min(moment, order.exchange.deadline());
    if (order.not_before > now)
      moment = std::min(moment, order.not_before);
  }
  alarm_.set(moment);
}

// The breaker hears of every try, also of one that is sent again.
void HttpClient::took_place(Place order, TryOutcome outcome) {
  const auto now = Steady::now();
  order->running.reset();
  --running_;
  note(*order, outcome, now);
  auto next =
      order->exchange.after(std::move(outcome), now, random_.fraction());
  if (const auto* again = std::get_if<Exchange::Again>(&next))
    order->not_before = now + again->pause;
  else
    finish(order, std::move(std::get<Exchange::Done>(next).outcome));
  turn();
}

// An answer that is too large or a certificate that is wrong says nothing about
// whether the service works.
void HttpClient::note(const Order& order, const TryOutcome& outcome,
                      Moment now) {
  auto& judged = breaker(order.server);
  if (is_trouble(outcome))
    judged.failed(order.pass, now,
                  outcome ? "answered " + std::to_string(outcome->status)
                          : outcome.error().reason);
  else if (outcome)
    judged.succeeded(order.pass);
  else
    judged.withdrawn(order.pass);
}

// The order is gone before `done` is called, which may submit another one.
void HttpClient::finish(Place order, TryOutcome outcome) {
  const auto done = std::move(order->done);
  orders_.erase(order);
  {
    const std::lock_guard lock(mutex_);
    --pending_;
  }
  done(std::move(outcome));
}

CircuitBreaker& HttpClient::breaker(const std::string& server) {
  return breakers_.try_emplace(server, options_.breaker).first->second;
}

// What was on its way may have arrived: `was_sent` says so.
void HttpClient::end() {
  is_over_ = true;
  while (!orders_.empty()) {
    const auto order = orders_.begin();
    if (order->running)
      transfers_->cancel(*order->running);
    auto cancelled = refused("is not asked any more, as the component ends");
    cancelled.error().was_sent = order->running.has_value();
    finish(order, std::move(cancelled));
  }
  alarm_.set(Alarm::never);
  transfers_.reset();
}

} // namespace parlour::adapters::http
