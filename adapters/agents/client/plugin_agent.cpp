#include "adapters/agents/client/plugin_agent.hpp"

#include <exception>
#include <optional>
#include <utility>

#include <asio.hpp>

#include "adapters/agents/client/agent_host.hpp"
#include "adapters/agents/wire/parameters.hpp"

namespace parlour::adapters::agents {

// `context_` runs on the thread of run(): the plug-in is called there. The
// connection has another thread, and posts what it learns.
class PluginAgent::Implementation : private AgentConnection::Listener {
public:
  explicit Implementation(PluginAgentOrder order)
      : order_(std::move(order)), stays_(context_.get_executor()),
        host_(order_.name, order_.data_folder, context_, outside()) {}

  Expected<void> run() {
    const auto outcome =
        guarded([this] { return begin().and_then([this] { return stay(); }); });
    const auto stopped = guarded([this]() -> Expected<void> {
      if (plugin_)
        plugin_->stop();
      return {};
    });
    connection_.reset(); // what the plug-in said last is still sent
    return outcome ? stopped : outcome;
  }

  void stop() {
    context_.stop();
  }

private:
  AgentHost::Outside outside() {
    return {
        .send =
            [this](AgentMessage message) {
              return connection_ && connection_->send(std::move(message));
            },
        .available =
            [this](bool is_available) {
              asio::post(context_, [this, is_available] {
                connection_->set_present(is_available);
              });
            },
        .failed = [this](const std::string& reason) { end(reason); },
        .log = order_.log,
    };
  }

  Expected<void> begin() {
    Hello hello;
    hello.name = order_.name;
    hello.roles = order_.factory.description.roles;
    hello.json = true;
    hello.token = order_.token;
    auto connection = AgentConnection::open(order_.address, hello, *this);
    if (!connection)
      return tl::make_unexpected(std::move(connection.error()));
    connection_ = std::move(*connection);
    plugin_ = order_.factory.create();
    if (!plugin_)
      return fail(ErrorKind::settings, "its factory made no plug-in");
    return plugin_->start(host_, order_.options);
  }

  // What the plug-in throws, wherever it is called.
  template <class Action>
  static Expected<void> guarded(Action action) {
    try {
      return action();
    } catch (const std::exception& thrown) {
      return fail(ErrorKind::thrown, thrown.what());
    } catch (...) {
      return fail(ErrorKind::thrown, "an exception of an unknown type");
    }
  }

  // Calls the plug-in until the end.
  Expected<void> stay() {
    context_.run();
    if (end_)
      return tl::make_unexpected(*end_);
    return {};
  }

  void end(const std::string& reason) {
    end_with({ErrorKind::thrown, reason, {}});
  }

  void end_with(Error error) {
    asio::post(context_, [this, error = std::move(error)] {
      if (!end_)
        end_ = error;
      context_.stop();
    });
  }

  // -- from the connection's thread -------------------------------------------

  void received(AgentMessage message) override {
    asio::post(context_, [this, message = std::move(message)] {
      const bool is_numbered = message.number.has_value();
      deal_with(message);
      if (is_numbered)
        connection_->handed_on();
    });
  }

  void note(const std::string& text) override {
    order_.log(text);
  }

  void offline() override {
    asio::post(context_, [this] { host_.end_requests(); });
  }

  void rejected(const Error& error) override {
    end_with(error);
  }

  // -- on the plug-in's thread ------------------------------------------------

  void deal_with(const AgentMessage& message) {
    if (host_.take_answer(message))
      return;
    if (auto made = message_from_agent(message, true))
      plugin_->receive(*made);
    else
      order_.log("a message of the platform cannot be read: " +
                 made.error().sentence);
  }

  const PluginAgentOrder order_;
  asio::io_context context_;
  asio::executor_work_guard<asio::io_context::executor_type> stays_;
  AgentHost host_;
  std::unique_ptr<AgentConnection> connection_;
  std::unique_ptr<IPlugin> plugin_;
  std::optional<Error> end_;
};

PluginAgent::PluginAgent(PluginAgentOrder order)
    : implementation_(std::make_unique<Implementation>(std::move(order))) {}

PluginAgent::~PluginAgent() = default;

Expected<void> PluginAgent::run() {
  return implementation_->run();
}

void PluginAgent::stop() {
  implementation_->stop();
}

} // namespace parlour::adapters::agents
