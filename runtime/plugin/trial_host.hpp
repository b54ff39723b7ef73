// TrialHost: a platform for one plug-in on trial: in its author's tests, and in
// the conformance test. Keeps what the plug-in fired, sent, asked and logged;
// its time stands still until it is moved.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

// The plug-in may call it from any thread; the test is one thread, which counts
// as the plug-in's own.
class TrialHost : public PluginHost {
public:
  void fire_event(Message event) override;
  void send_message(Message message) override;
  // Nobody is there: the answer, due at once, is an error of kind Offline.
  void ask(Message request, Milliseconds patience, Reaction reaction) override;
  DelayId after(Milliseconds delay, std::function<void()> action) override;
  void cancel(DelayId delay) override;
  void failed(const std::string& reason) override;
  const Clock& clock() const override;
  void log(const std::string& text) override;
  std::shared_ptr<const UnderstandingModel> understanding() const override;
  std::shared_ptr<const PhraseEvaluator> phrases() const override;
  Expected<std::vector<std::string>>
  column(const std::string& name) const override;
  std::string data_folder() const override;
  std::string application_folder() const override;

  // What came since the last call.
  std::vector<Message> take_events();
  std::vector<Message> take_sent();
  std::vector<Message> take_asked();
  std::vector<std::string> take_logs();
  // Reasons why it is broken, as it says.
  std::vector<std::string> take_failures();

  // Time passes, with all that falls due in it.
  void advance(Milliseconds time);
  // Waits until `done` holds, asked after each event: what is due within
  // `patience` is due now, and other threads of the plug-in get that long in
  // real time. False where it never held.
  bool wait(const std::function<bool()>& done, Milliseconds patience);

  std::string data;
  std::string application;

private:
  struct Later {
    DelayId id = 0;
    Timestamp due = 0;
    std::function<void()> action;
  };
  class StillClock : public Clock {
  public:
    Timestamp now() const override {
      return time;
    }
    std::atomic<Timestamp> time = 0;
  };

  bool run_next(Timestamp until);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  StillClock clock_;
  std::vector<Later> later_;
  std::vector<Message> events_;
  std::vector<Message> sent_;
  std::vector<Message> asked_;
  std::vector<std::string> logs_;
  std::vector<std::string> failures_;
  std::size_t fired_ = 0;
  DelayId last_ = 0;
};

} // namespace parlour
