// Desk is the PluginHost of a single component in a bench. It collects the
// events that the component fires, from any thread.
#pragma once

#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// fire_event is thread-safe; one thread takes the events. All other requests
// are ignored.
class Desk : public PluginHost {
public:
  // The application's folder and the data folder in one.
  explicit Desk(std::string folder) : folder_(std::move(folder)) {}

  // Waits for events and returns all since the last call. The vector is passed
  // back and forth to reuse its memory.
  void take(std::vector<Message>& events);

  void fire_event(Message event) override;
  void send_message(Message) override {}
  void ask(Message, Milliseconds, Reaction) override {}
  DelayId after(Milliseconds, std::function<void()>) override {
    return 0;
  }
  void cancel(DelayId) override {}
  void failed(const std::string&) override {}
  void available(bool) override {}
  const Clock& clock() const override {
    return clock_;
  }
  void log(const std::string&) override {}
  std::shared_ptr<const UnderstandingModel> understanding() const override {
    return nullptr;
  }
  std::shared_ptr<const PhraseEvaluator> phrases() const override {
    return nullptr;
  }
  Expected<std::vector<std::string>> column(const std::string&) const override {
    return std::vector<std::string>{};
  }
  std::string data_folder() const override {
    return folder_;
  }
  std::string application_folder() const override {
    return folder_;
  }

private:
  std::string folder_;
  SystemClock clock_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::vector<Message> events_;
};

} // namespace parlour::tools
