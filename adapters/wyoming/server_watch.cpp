#include "adapters/wyoming/server_watch.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::wyoming {

namespace {

using Steady = std::chrono::steady_clock;

constexpr Milliseconds longest_pause{60'000};

bool offers(const nlohmann::json& info, const std::string& service) {
  const auto found = info.find(service);
  return found != info.end() && found->is_array() && !found->empty();
}

} // namespace

ServerWatch::ServerWatch(const Route& route, WatchOptions options,
                         WatchCalls calls)
    : route_(route), options_(std::move(options)), calls_(std::move(calls)),
      alarm_(route.loop, [this] { rung(); }), pause_(options_.first_pause) {}

void ServerWatch::start() {
  connection_ = std::make_unique<Connection>(
      route_,
      ConnectionCalls{[this](const Event& event) { received(event); },
                      [this](const std::string& reason) { lose(reason); }});
  ask();
}

// Who says other things than the answer has no more than the alarm's time.
void ServerWatch::ask() {
  is_asked_ = true;
  alarm_.set(Steady::now() + route_.connect_timeout + options_.answer_timeout);
  connection_->send({"describe"});
  connection_->expect(options_.answer_timeout);
}

void ServerWatch::received(const Event& event) {
  if (event.type != "info" && is_asked_)
    return connection_->expect(options_.answer_timeout);
  if (event.type != "info")
    return;
  if (!offers(event.data, options_.service))
    return lose("it does not offer the service '" + options_.service + "'");
  is_asked_ = false;
  pause_ = options_.first_pause;
  alarm_.set(Steady::now() + options_.ask_every);
  if (!std::exchange(is_up_, true))
    calls_.up();
}

void ServerWatch::lose(const std::string& reason) {
  connection_.reset();
  is_asked_ = false;
  alarm_.set(Steady::now() + pause_);
  pause_ = std::min(pause_ * 2, longest_pause);
  is_up_ = false;
  calls_.down(reason);
}

void ServerWatch::rung() {
  if (is_asked_)
    lose("it does not answer in time");
  else if (connection_)
    ask();
  else
    start();
}

} // namespace parlour::adapters::wyoming
