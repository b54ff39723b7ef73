// RemoteHost: the platform as a plug-in in a process of its own sees it: what
// it is asked goes through the socket.
#pragma once

#include <atomic>
#include <future>
#include <mutex>

#include "adapters/process/frame_socket.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Safe to use from any thread, as its contract says.
class RemoteHost : public PluginHost {
public:
  explicit RemoteHost(FrameSocket& socket) : socket_(socket), clock_(*this) {}

  // -- for whoever reads the socket and calls the plug-in ---------------------

  // Keeps what the frame `start` tells; the options in it.
  Expected<Options> begin(const Frame& start);
  void set_time(Timestamp now) {
    told_ = now;
  }
  void run(std::int64_t delay);
  void react(const Frame& answer);
  void answered(const Frame& reply);
  // Throws where it is too long for the socket.
  void say(const Frame& frame);

  // -- the contract -----------------------------------------------------------

  void fire_event(Message event) override;
  void send_message(Message message) override;
  void ask(Message request, Milliseconds patience, Reaction reaction) override;
  DelayId after(Milliseconds delay, std::function<void()> action) override;
  void cancel(DelayId delay) override;
  void failed(const std::string& reason) override;
  const Clock& clock() const override {
    return clock_;
  }
  void log(const std::string& text) override;
  std::shared_ptr<const UnderstandingModel> understanding() const override {
    return understanding_;
  }
  std::shared_ptr<const PhraseEvaluator> phrases() const override {
    return phrases_;
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
  // The machine's, or where time is virtual, the one told last.
  class ToldClock : public Clock {
  public:
    explicit ToldClock(const RemoteHost& host) : host_(host) {}
    Timestamp now() const override;

  private:
    const RemoteHost& host_;
  };
  class Phrases;

  Expected<Value> inquire(FrameKind kind, Value what) const;

  FrameSocket& socket_;
  const ToldClock clock_;
  std::atomic<Timestamp> told_ = 0;
  bool real_time_ = false;
  std::string data_folder_;
  std::string application_folder_;
  std::shared_ptr<const UnderstandingModel> understanding_;
  std::shared_ptr<const PhraseEvaluator> phrases_;

  mutable std::mutex mutex_;
  mutable std::int64_t last_ = 0; // of delays and questions
  std::map<DelayId, std::function<void()>> delays_;
  std::map<std::int64_t, Reaction> reactions_; // to other components' answers
  mutable std::map<std::int64_t, std::promise<Expected<Value>>> questions_;
};

} // namespace parlour::adapters
