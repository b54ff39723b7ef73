#include "adapters/wyoming/client.hpp"

#include <utility>

#include "adapters/wyoming/audio_events.hpp"

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

Expected<std::unique_ptr<Client>>
Client::start(PluginHost& host, const Options& options,
              const std::vector<OptionDescription>& descriptions,
              const std::string& service) {
  auto text = [&](const char* name) {
    return option_value(options, descriptions, name);
  };
  auto address = parse_address(text("address"));
  if (!address)
    return fail(ErrorKind::settings, "option 'address' is a server such as "
                                     "192.168.1.7:10300, not '" +
                                         text("address") + "'");
  Milliseconds times[3];
  const char* names[] = {"connect-timeout", "answer-timeout", "pause"};
  for (int i = 0; i < 3; ++i) {
    times[i] = parse_duration(text(names[i])).value_or(Milliseconds(0));
    if (times[i] <= Milliseconds(0))
      return fail(ErrorKind::settings, "option '" + std::string(names[i]) +
                                           "' is a time longer than nothing");
  }
  auto loop =
      Loop::start([&host](const std::string& what) { host.failed(what); });
  if (!loop)
    return tl::make_unexpected(loop.error());
  std::unique_ptr<Client> made(
      new Client(std::move(*loop), std::move(*address)));
  made->route_.connect_timeout = times[0];
  made->answer_timeout_ = times[1];
  made->pause_ = times[2];
  made->one_by_one_ = text("one-by-one") == "true";
  made->watch_ = std::make_unique<ServerWatch>(
      made->route_, WatchOptions{service, times[1], times[2]},
      made->watch_calls(host));
  made->post([client = made.get()] { client->watch_->start(); });
  return made;
}

Client::Client(std::unique_ptr<Loop> loop, Address address)
    : loop_(std::move(loop)), route_{*loop_, resolver_, std::move(address)} {}

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
