// AgentHost is the PluginHost of a plug-in that runs as a remote agent: what it
// fires, sends and asks goes to the platform by messages of the protocol.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "adapters/agents/wire/agent_message.hpp"
#include "runtime/plugin/plugin.hpp"

namespace asio {
class io_context;
}

namespace parlour::adapters::agents {

// Safe to use from any thread, as PluginHost promises.
class AgentHost : public PluginHost {
public:
  // What it needs of its owner. The functions are called on any thread.
  struct Outside {
    // Queues a message. False: too much waits.
    std::function<bool(AgentMessage message)> send;
    std::function<void(bool is_available)> available;
    std::function<void(const std::string& reason)> failed;
    std::function<void(const std::string& text)> log;
  };

  // `context` runs on the plug-in's thread and outlives this.
  AgentHost(std::string name, std::string data_folder,
            asio::io_context& context, Outside outside);
  ~AgentHost() override;

  // On the plug-in's thread: a message of the platform. False: it answers
  // nothing that the plug-in has asked, and is a message for the plug-in.
  bool take_answer(const AgentMessage& message);
  // On the plug-in's thread: the platform is away, and nobody answers.
  void end_requests();

  void fire_event(Message event) override;
  void send_message(Message message) override;
  void ask(Message request, Milliseconds patience, Reaction reaction) override;
  DelayId after(Milliseconds delay, std::function<void()> action) override;
  void cancel(DelayId delay) override;
  void failed(const std::string& reason) override;
  void available(bool is_available) override;
  const Clock& clock() const override;
  void log(const std::string& text) override;
  // The application's resources stay with the platform.
  std::shared_ptr<const UnderstandingModel> understanding() const override;
  std::shared_ptr<const PhraseEvaluator> phrases() const override;
  Expected<std::vector<std::string>>
  column(const std::string& name) const override;
  std::string data_folder() const override;
  // The platform's folders are not this process's: the same as data_folder().
  std::string application_folder() const override;

private:
  struct Timers;

  void say(Message message);
  void end_request(std::uint64_t number, Expected<Message> outcome);

  const std::string name_;
  const std::string data_folder_;
  asio::io_context& context_;
  const Outside outside_;
  const SystemClock clock_;
  std::unique_ptr<Timers> timers_;

  std::mutex mutex_; // of what follows
  // Not from 1: an answer to an earlier process must not answer this one, nor
  // an error about the answer to a request of the platform.
  std::uint64_t last_request_;
  std::map<std::uint64_t, Reaction> reactions_;
};

} // namespace parlour::adapters::agents
