#include "adapters/wyoming/server_watch.hpp"

#include <utility>

namespace parlour::adapters::wyoming {

namespace {

using Steady = std::chrono::steady_clock;

// A server that comes back is used after a minute at the latest.
constexpr Milliseconds longest_pause{60'000};

// The answer `info` has a list for each service; an empty one means that the
// server knows the service and has nothing for it.
bool offers(const nlohmann::json& info, const std::string& service) {
  const auto found = info.find(service);
  return found != info.end() && found->is_array() && !found->empty();
}

} // namespace

// What the watch does, and what follows from the answer:
//
//   start, ask            describe is sent; the alarm limits the answer
//   info with the service it is up; asked again after ask_every
//   no answer, no service it is down; tried again after a pause, which doubles
ServerWatch::ServerWatch(const Route& route, WatchOptions options,
                         WatchCalls calls)
    : route_(route), options_(std::move(options)), calls_(std::move(calls)),
      alarm_(route.loop, [this] { rung(); }),
      backoff_(options_.first_pause, longest_pause) {}

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

// An answer sets the pause back: the next loss is tried again soon.
void ServerWatch::received(const Event& event) {
  if (event.type != "info" && is_asked_)
    return connection_->expect(options_.answer_timeout);
  if (event.type != "info")
    return;
  if (!offers(event.data, options_.service))
    return lose("it does not offer the service '" + options_.service + "'");
  is_asked_ = false;
  backoff_.reset();
  alarm_.set(Steady::now() + options_.ask_every);
  if (!std::exchange(is_up_, true))
    calls_.up();
}

// The caller may be the connection that goes: it tells only at its end.
void ServerWatch::lose(const std::string& reason) {
  connection_.reset();
  is_asked_ = false;
  alarm_.set(Steady::now() + backoff_.after_failure());
  is_up_ = false;
  calls_.down(reason);
}

// The alarm's meaning follows from what is under way.
void ServerWatch::rung() {
  if (is_asked_)
    lose("it does not answer in time");
  else if (connection_)
    ask();
  else
    start();
}

} // namespace parlour::adapters::wyoming
