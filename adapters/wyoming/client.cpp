#include "adapters/wyoming/client.hpp"

#include <utility>

#include "adapters/wyoming/audio_events.hpp"
#include "runtime/plugin/option_reader.hpp"

namespace parlour::adapters::wyoming {

std::vector<OptionDescription> client_options(const std::string& port) {
  using Type = OptionType;
  return {{"address", "localhost:" + port, "the server, as host:port"},
          {"connect-timeout", "5s", "how long connecting may take", false,
           Type::duration},
          {"answer-timeout", "10s", "how long the server may say nothing",
           false, Type::duration},
          {"pause", "1s",
           "the first pause before it connects again; each is twice as long as "
           "the last, up to a minute",
           false, Type::duration},
          {"one-by-one", "false",
           "answers each message before it takes the next: where time is "
           "virtual",
           false, Type::boolean}};
}

// A server that is not there is no error: the component starts, is not
// available, and is tried again by the watch.
Expected<std::unique_ptr<Client>>
Client::start(PluginHost& host, const Options& options,
              const std::vector<OptionDescription>& descriptions,
              const std::string& service) {
  constexpr Milliseconds shortest{1};
  OptionReader read(options, descriptions);
  auto address = parse_address(read.text("address"));
  if (!address)
    read.wrong("address", "is a server such as 192.168.1.7:10300, not '" +
                              read.text("address") + "'");
  const auto connect_timeout = read.duration("connect-timeout", shortest);
  const auto answer_timeout = read.duration("answer-timeout", shortest);
  const auto pause = read.duration("pause", shortest);
  if (const auto outcome = read.outcome(); !outcome)
    return tl::make_unexpected(outcome.error());
  auto loop =
      Loop::start([&host](const std::string& what) { host.failed(what); });
  if (!loop)
    return tl::make_unexpected(loop.error());
  std::unique_ptr<Client> made(
      new Client(std::move(*loop), std::move(*address)));
  made->route_.connect_timeout = connect_timeout;
  made->answer_timeout_ = answer_timeout;
  made->pause_ = pause;
  made->one_by_one_ = read.truth("one-by-one");
  made->watch_ = std::make_unique<ServerWatch>(
      made->route_, WatchOptions{service, answer_timeout, pause},
      made->watch_calls(host));
  made->post([client = made.get()] { client->watch_->start(); });
  return made;
}

Client::Client(std::unique_ptr<Loop> loop, Address address)
    : loop_(std::move(loop)), route_{*loop_, resolver_, std::move(address)} {}

// Called on the loop's thread; PluginHost may be called from any.
WatchCalls Client::watch_calls(PluginHost& host) {
  const auto server =
      "the Wyoming server " + route_.address.host + ":" + route_.address.port;
  return {[this, &host, server] {
            reason_.clear();
            host.log("connected to " + server);
            host.available(true);
          },
          [this, &host, server](const std::string& reason) {
            // The same reason again, attempt by attempt, is no news.
            if (std::exchange(reason_, reason) != reason)
              host.log(server + " is of no use now: " + reason);
            host.available(false);
          }};
}

Client::~Client() {
  end([] {});
}

// Recognisers and wake words begin alike: what is wanted, then the format of
// the audio.
std::unique_ptr<Connection> Client::connect(const SessionId& session,
                                            const SessionCalls& calls,
                                            const Event& request) const {
  auto made = std::make_unique<Connection>(
      route_, ConnectionCalls{[&calls, session](const Event& event) {
                                calls.received(session, event);
                              },
                              [&calls, session](const std::string& reason) {
                                calls.closed(session, reason);
                              }});
  made->send(request);
  made->send(audio_start());
  return made;
}

void Client::post(Loop::Action action) {
  loop_->post(std::move(action));
}

// Counted before it is posted, so that many threads at once keep the bound.
bool Client::post(Loop::Action action, std::size_t bytes) {
  if (posted_.fetch_add(bytes) + bytes > max_posted) {
    posted_ -= bytes;
    return false;
  }
  loop_->post([this, action = std::move(action), bytes] {
    posted_ -= bytes;
    action();
  });
  return true;
}

void Client::post(const SessionId& session, Loop::Action action,
                  std::size_t bytes, Loop::Action lost) {
  if (post(std::move(action), bytes))
    return;
  const std::lock_guard lock(mutex_);
  if (!losing_.insert(session).second)
    return;
  post([this, session, lost = std::move(lost)] {
    {
      const std::lock_guard locked(mutex_);
      losing_.erase(session);
    }
    lost();
  });
}

// The watch goes on the loop's thread, where its connection lives.
void Client::end(Loop::Action action) {
  if (std::exchange(is_ended_, true))
    return;
  loop_->post([this, action = std::move(action)] {
    action();
    watch_.reset();
  });
  loop_->stop();
}

} // namespace parlour::adapters::wyoming
