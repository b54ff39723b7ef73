// TestHost: a PluginHost for testing one plug-in without the platform, in its
// author's unit tests and in the conformance test. It records what the plug-in
// fired, sent, asked and logged. Its time stands still until the test moves it:
//
//   TestHost host;
//   EchoTTS plugin;
//   plugin.start(host, {});
//   plugin.receive(speak_message);
//   EXPECT_EQ(host.take_events().back().command, "Finished");
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

// The plug-in may call it from any thread. The test must be one thread, which
// counts as the plug-in's own thread.
class TestHost : public PluginHost {
public:
  void fire_event(Message event) override;
  void send_message(Message message) override;
  // No other component exists: the answer, due at once, is an error of kind
  // Offline.
  void ask(Message request, Milliseconds patience, Reaction reaction) override;
  DelayId after(Milliseconds delay, std::function<void()> action) override;
  void cancel(DelayId delay) override;
  void failed(const std::string& reason) override;
  void available(bool is_available) override;
  const Clock& clock() const override;
  void log(const std::string& text) override;
  std::shared_ptr<const UnderstandingModel> understanding() const override;
  std::shared_ptr<const PhraseEvaluator> phrases() const override;
  Expected<std::vector<std::string>>
  column(const std::string& name) const override;
  std::string data_folder() const override;
  std::string application_folder() const override;

  // Each returns what was recorded since its last call.
  std::vector<Message> take_events();
  std::vector<Message> take_sent();
  std::vector<Message> take_asked();
  std::vector<std::string> take_logs();
  // The reasons that the plug-in gave when it called failed().
  std::vector<std::string> take_failures();

  // What the plug-in said last by available().
  bool is_available() const;

  // Moves the time forward and runs the delays that become due, in order.
  void advance(Milliseconds time);
  // Waits until `done` returns true; it is asked again after whatever the
  // plug-in says. Delays that are due within `patience` run at once, and the
  // plug-in's own threads get that much real time. Returns false if `done`
  // never held.
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

  void note_change();
  // Runs the next delay that is due by then; false if there is none.
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
  bool available_ = true;
  std::size_t changes_ = 0; // of anything that a plug-in may say
  DelayId last_ = 0;
};

} // namespace parlour
