#include "adapters/mqtt/mqtt_link.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::mqtt {

namespace {

using Steady = std::chrono::steady_clock;

// A server that comes back is used after a minute at the latest.
constexpr Milliseconds longest_pause{60'000};
// A server that accepts and drops at once must not be tried without a pause.
constexpr Milliseconds holds{10'000};

// How often the library looks whether the server is still there.
Milliseconds care(Milliseconds keep_alive) {
  return std::max(keep_alive / 4, Milliseconds(1'000));
}

} // namespace

MQTTLink::MQTTLink(Loop& loop, ServerOptions options, LinkCalls calls)
    : loop_(loop), options_(std::move(options)), calls_(std::move(calls)),
      backoff_(options_.pause, longest_pause),
      watch_(loop, [this](short events) { ready(events); }),
      alarm_(loop, [this] { rung(); }), resolver_(std::in_place) {}

MQTTLink::~MQTTLink() = default;

void MQTTLink::start() {
  attempt();
}

void MQTTLink::stop() {
  phase_ = Phase::stopped;
  resolver_.reset();
  alarm_.set(Alarm::never);
  watch_.stop();
  if (client_)
    client_->say_goodbye();
  client_.reset();
}

// -- connecting ---------------------------------------------------------------

// The name is looked up first on another thread: the library does it as well,
// but would stop the loop for many seconds if nobody answers.
void MQTTLink::attempt() {
  phase_ = Phase::looking_up;
  deadline_ = Steady::now() + options_.connect_timeout;
  alarm_.set(deadline_);
  const auto number = ++attempt_;
  resolver_->resolve({options_.host, std::to_string(options_.port)},
                     [this, number](const Endpoints& endpoints) {
                       loop_.post([this, number, endpoints] {
                         if (phase_ == Phase::looking_up && number == attempt_)
                           found(endpoints);
                       });
                     });
}

// The addresses themselves are not used: the library looks them up again, which
// is quick by then.
void MQTTLink::found(const Endpoints& endpoints) {
  if (!endpoints)
    return lose(endpoints.error().message);
  connect();
}

void MQTTLink::connect() {
  phase_ = Phase::connecting;
  client_ = std::make_unique<MQTTClient>(options_);
  went_on(client_->connect());
}

// -- events -------------------------------------------------------------------

void MQTTLink::ready(short events) {
  went_on(client_->proceed(events));
}

// One alarm for three purposes, told apart by the phase.
void MQTTLink::rung() {
  if (phase_ == Phase::pausing)
    return attempt();
  if (phase_ == Phase::up) {
    tend_later();
    return went_on(client_->tend());
  }
  if (Steady::now() >= deadline_)
    lose("it takes too long to connect");
}

void MQTTLink::went_on(const Expected<void>& outcome) {
  if (outcome && client_->is_up() && phase_ == Phase::connecting) {
    phase_ = Phase::up;
    up_since_ = Steady::now();
    tend_later();
    calls_.up();
  }
  // Whatever came before a loss counts.
  if (client_)
    hand_over();
  if (!outcome)
    return lose(outcome.error().message);
  wait();
}

// Receipts first, as they were waited for longer.
void MQTTLink::hand_over() {
  for (const auto number : client_->receipts())
    if (const auto found = tickets_.extract(number))
      calls_.published(found.mapped());
  for (auto& one : client_->publications())
    calls_.received(std::move(one));
}

void MQTTLink::wait() {
  if (!client_ || phase_ == Phase::stopped)
    return;
  // The library may have opened another socket with the same number.
  if (client_->socket() != watched_)
    watch_.stop();
  watched_ = client_->socket();
  watch_.await(watched_, client_->interest());
  alarm_.set(phase_ == Phase::up ? tend_at_ : deadline_);
}

// Not put off by what arrives: the server hears of us only by what we send.
void MQTTLink::tend_later() {
  tend_at_ = Steady::now() + care(options_.keep_alive);
}

// Tickets without a receipt are forgotten: the requests fail by `down`.
void MQTTLink::lose(const std::string& reason) {
  watch_.stop();
  watched_ = -1;
  client_.reset();
  tickets_.clear();
  if (phase_ == Phase::up && Steady::now() - up_since_ >= holds)
    backoff_.reset();
  phase_ = Phase::pausing;
  alarm_.set(Steady::now() + backoff_.after_failure());
  calls_.down(reason);
}

// Whoever calls may be in the middle of something.
void MQTTLink::lose_soon(const Expected<void>& outcome) {
  if (outcome)
    return;
  loop_.post([this, number = attempt_, reason = outcome.error().message] {
    if (phase_ == Phase::up && number == attempt_)
      lose(reason);
  });
}

// -- messages -----------------------------------------------------------------

void MQTTLink::subscribe(const std::string& filter) {
  if (phase_ == Phase::up)
    lose_soon(client_->subscribe(filter));
}

void MQTTLink::unsubscribe(const std::string& filter) {
  if (phase_ == Phase::up)
    lose_soon(client_->unsubscribe(filter));
}

bool MQTTLink::publish(const Publish& publication) {
  if (phase_ != Phase::up)
    return false;
  const auto number = client_->publish(publication.topic, publication.payload,
                                       publication.retain);
  if (!number) {
    lose_soon(tl::make_unexpected(number.error()));
    return false;
  }
  tickets_[*number] = publication.ticket;
  // What the socket does not take at once waits for it.
  wait();
  return true;
}

} // namespace parlour::adapters::mqtt
