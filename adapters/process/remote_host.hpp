// RemoteHost is the PluginHost that a plug-in sees in a process of its own. It
// sends each request through the socket and matches the answers to it by
// number.
#pragma once

#include <atomic>
#include <future>
#include <mutex>

#include "adapters/process/ipc_socket.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Thread-safe, as the contract of PluginHost demands.
class RemoteHost : public PluginHost {
public:
  explicit RemoteHost(IpcSocket& socket) : socket_(socket), clock_(*this) {}

  // -- for whoever reads the socket and calls the plug-in ---------------------

  // Keeps the data of a `start` message. Returns the options in it.
  Expected<Options> begin(const IpcMessage& start);
  // Virtual time, told with each call.
  void set_time(Timestamp now) {
    told_ = now;
  }
  // Calls the action of a timer, if it was not cancelled.
  void run(std::int64_t delay);
  // Calls the reaction to another component's answer.
  void react(const IpcMessage& answer);
  // Wakes the thread that waits for the answer to a question. Called by the
  // reading thread, while the plug-in's thread waits.
  void answered(const IpcMessage& reply);
  // Sends a message. Throws if it is too long. A closed connection is ignored:
  // the reading thread ends the process.
  void say(const IpcMessage& message);

  // -- the contract -----------------------------------------------------------

  void fire_event(Message event) override;
  void send_message(Message message) override;
  void ask(Message request, Milliseconds patience, Reaction reaction) override;
  DelayId after(Milliseconds delay, std::function<void()> action) override;
  void cancel(DelayId delay) override;
  void failed(const std::string& reason) override;
  void available(bool is_available) override;
  const Clock& clock() const override {
    return clock_;
  }
  void log(const std::string& text) override;
  std::shared_ptr<const UnderstandingModel> understanding() const override {
    return language().understanding;
  }
  std::shared_ptr<const PhraseEvaluator> phrases() const override {
    return language().phrases;
  }
  Expected<std::vector<std::string>>
  column(const std::string& name) const override;
  std::string data_folder() const override {
    return data_folder_;
  }
  std::string application_folder() const override {
    return application_folder_;
  }

private:
  // The system's clock, or in virtual time the time that was told last.
  class ToldClock : public Clock {
  public:
    explicit ToldClock(const RemoteHost& host) : host_(host) {}
    Timestamp now() const override;

  private:
    const RemoteHost& host_;
  };
  class Phrases;
  struct Language {
    std::shared_ptr<const UnderstandingModel> understanding;
    std::shared_ptr<const PhraseEvaluator> phrases;
  };

  // Asks the platform and waits for the answer.
  Expected<Value> inquire(IpcKind kind, Value what) const;
  // Asked for once. Throws if it cannot be sent or read; empty if nobody is
  // there any more.
  const Language& language() const;
  Language ask_language() const;

  IpcSocket& socket_;
  const ToldClock clock_;
  std::atomic<Timestamp> told_ = 0;
  bool real_time_ = false;
  std::string data_folder_;
  std::string application_folder_;
  mutable std::once_flag has_asked_;
  mutable Language language_;

  mutable std::mutex mutex_;
  // The last number given to a timer, a question or a request.
  mutable std::int64_t last_ = 0;
  std::map<DelayId, std::function<void()>> delays_;
  // Reactions to other components' answers, by request.
  std::map<std::int64_t, Reaction> reactions_;
  mutable std::map<std::int64_t, std::promise<Expected<Value>>> questions_;
};

} // namespace parlour::adapters
