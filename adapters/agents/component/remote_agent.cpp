// Threads: the platform calls the plug-in on one thread, the server its
// correspondence on another; PluginHost may be called from both.
#include "adapters/agents/component/remote_agent.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "adapters/agents/component/wire_numbers.hpp"
#include "adapters/agents/wire/parameters.hpp"

namespace parlour::adapters::agents {

namespace {

// What the platform and the agent say to each other. Requests that the agent
// has made keep it alive until they end.
class Correspondence : public AgentServer::Component,
                       public std::enable_shared_from_this<Correspondence> {
public:
  Correspondence(const RemoteAgentOrder& order, PluginHost& host,
                 std::shared_ptr<AgentServer> server)
      : order_(order), host_(host), server_(std::move(server)) {}

  // The message as the agent gets it. The error says that it has more than one
  // payload.
  Read<AgentMessage> outgoing(const Message& message) {
    std::lock_guard lock(mutex_);
    const bool is_asked = message.correlation != 0;
    auto made = message_for_agent(message, json_,
                                  is_asked ? std::optional(order_.patience)
                                           : std::nullopt);
    if (made && is_asked)
      made->correlation =
          numbers_.number_for({message.session, message.correlation});
    return made;
  }

  void online(const Hello& hello) override {
    {
      std::lock_guard lock(mutex_);
      json_ = hello.json;
    }
    tell_of_roles(hello.roles);
    host_.available(true);
  }

  void offline() override {
    host_.available(false);
  }

  std::optional<WireError> received(AgentMessage message) override {
    auto made = message.sinks.empty() ? incoming(message) : read(message);
    if (!made)
      return std::move(made.error());
    if (made->sinks.empty())
      host_.fire_event(std::move(*made));
    else if (message.correlation)
      ask(std::move(*made), message);
    else
      host_.send_message(std::move(*made));
    return {};
  }

  void refused(const AgentMessage& message, const Error& error) override {
    const auto asker = asker_of(message);
    if (!asker)
      return host_.log(fmt::format("{} did not reach the agent: {}",
                                   message.command, error.message));
    Message answer;
    answer.source = order_.name;
    answer.command = "Failed";
    answer.params = {error.message};
    answer.session = asker->session;
    answer.correlation = asker->correlation;
    host_.fire_event(std::move(answer));
  }

  void failed(const std::string& reason) noexcept override {
    host_.failed(reason);
  }

private:
  // A line for an agent that connects, once a second at most.
  void tell_of_roles(const std::vector<std::string>& roles) {
    std::vector<std::string> others;
    for (const auto& role : roles)
      if (!std::ranges::count(order_.roles, role))
        others.push_back(role);
    const auto now = host_.clock().now();
    if (others.empty() || (told_of_roles_ && now - *told_of_roles_ < 1000))
      return;
    told_of_roles_ = now;
    host_.log(fmt::format("the agent says that it fills {}; the settings do "
                          "not, so nobody asks it for that",
                          excerpt(fmt::format("{}", fmt::join(others, ", ")))));
  }

  std::optional<WireNumbers::Asker> asker_of(const AgentMessage& message) {
    std::lock_guard lock(mutex_);
    const auto* asker =
        message.correlation ? numbers_.find(*message.correlation) : nullptr;
    return asker ? std::optional(*asker) : std::nullopt;
  }

  // The message without the agent's own correlation, which means nothing to
  // others.
  Read<Message> read(const AgentMessage& message) {
    std::lock_guard lock(mutex_);
    auto made = message_from_agent(message, json_);
    if (made)
      made->correlation = 0;
    return made;
  }

  // An event. An answer belongs to the conversation that asked, whatever the
  // agent says.
  Read<Message> incoming(const AgentMessage& message) {
    auto made = read(message);
    if (const auto asker = asker_of(message); made && asker) {
      made->session = asker->session;
      made->correlation = asker->correlation;
    }
    return made;
  }

  // The agent asks another component; the answer carries its correlation again.
  void ask(Message request, const AgentMessage& message) {
    const auto number = message.correlation;
    if (request.sinks.size() != 1)
      return answer(number, fail(ErrorKind::settings,
                                 "a request is for one component, not for "
                                 "several"));
    auto patience = order_.patience;
    if (message.deadline && *message.deadline < max_patience)
      patience = Milliseconds(*message.deadline);
    host_.ask(std::move(request), patience,
              [self = shared_from_this(), number](Expected<Message> outcome) {
                self->answer(number, std::move(outcome));
              });
  }

  void answer(std::optional<std::uint64_t> number, Expected<Message> outcome) {
    Message event;
    if (outcome) {
      event = std::move(*outcome);
    } else {
      event.source = "Parlour";
      event.command = "Failed";
      event.params = {outcome.error().message};
    }
    event.sinks.clear();
    event.correlation = 0;
    std::unique_lock lock(mutex_);
    auto made = message_for_agent(event, json_);
    lock.unlock();
    if (!made)
      return answer(number, fail(ErrorKind::limit, made.error().sentence));
    made->correlation = number;
    server_->send(order_.name, std::move(*made));
  }

  static constexpr std::uint64_t max_patience = 3'600'000; // an hour

  const RemoteAgentOrder order_;
  PluginHost& host_;
  const std::shared_ptr<AgentServer> server_;
  // The server's thread alone uses it.
  std::optional<Timestamp> told_of_roles_;
  std::mutex mutex_; // of what follows
  // Whether the agent reads parameters in JSON.
  bool json_ = false;
  WireNumbers numbers_;
};

class RemoteAgent : public IPlugin {
public:
  RemoteAgent(RemoteAgentOrder order, std::shared_ptr<AgentServer> server)
      : order_(std::move(order)), server_(std::move(server)) {}

  // Once this has returned, the server calls nobody any more.
  void stop() override {
    if (server_)
      server_->detach(order_.name, correspondence_.get());
  }

protected:
  Expected<void> on_start(const Options&) override {
    correspondence_ = std::make_shared<Correspondence>(order_, host(), server_);
    host().available(false);
    if (server_)
      server_->attach(order_.name, correspondence_);
    return {};
  }

  void on_message(const Message& message) override {
    auto made = correspondence_->outgoing(message);
    if (!made)
      fire_event("Failed", {made.error().sentence});
    else if (server_)
      server_->send(order_.name, std::move(*made));
    else
      fire_event("Failed", {order_.name + " is not connected"});
  }

private:
  const RemoteAgentOrder order_;
  const std::shared_ptr<AgentServer> server_;
  std::shared_ptr<Correspondence> correspondence_;
};

} // namespace

PluginFactory remote_agent(RemoteAgentOrder order,
                           std::shared_ptr<AgentServer> server) {
  PluginDescription description;
  description.name = "RemoteAgent";
  description.roles = order.roles;
  description.sentence = "a process of its own that connects by itself";
  return {std::move(description), [order = std::move(order), server] {
            return std::make_unique<RemoteAgent>(order, server);
          }};
}

} // namespace parlour::adapters::agents
