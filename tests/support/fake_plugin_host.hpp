// FakePluginHost: the host of a plug-in in a test. It records what is fired,
// sent and logged, and runs delayed calls when the test moves the clock. For
// one thread.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/plugin/plugin.hpp"
#include "tests/support/manual_clock.hpp"

namespace parlour::test {

class FakePluginHost : public PluginHost {
public:
  void fire_event(Message event) override {
    events.push_back(event);
  }
  void send_message(Message message) override {
    sent.push_back(message);
  }
  void ask(Message request, Milliseconds, Reaction reaction) override {
    asked.push_back({std::move(request), std::move(reaction)});
  }
  DelayId after(Milliseconds delay, std::function<void()> action) override {
    later_.push_back({time.now() + delay.count(), std::move(action), ++last_});
    return last_;
  }
  void cancel(DelayId delay) override {
    std::erase_if(later_, [&](const Later& one) { return one.id == delay; });
  }
  // The number of delayed calls that have not run yet.
  std::size_t pending() const {
    return later_.size();
  }
  void failed(const std::string& reason) override {
    failures.push_back(reason);
  }
  void available(bool is_available) override {
    availability.push_back(is_available);
  }
  const Clock& clock() const override {
    return time;
  }
  void log(const std::string& text) override {
    logs.push_back(text);
  }
  std::shared_ptr<const UnderstandingModel> understanding() const override {
    return model;
  }
  std::shared_ptr<const PhraseEvaluator> phrases() const override {
    return evaluator;
  }
  Expected<std::vector<std::string>>
  column(const std::string& name) const override {
    if (columns)
      return columns(name);
    return fail(ErrorKind::database, "the test has no column " + name);
  }
  std::string data_folder() const override {
    return data;
  }
  std::string application_folder() const override {
    return application;
  }

  // Moves the clock, and runs what falls due on the way in order.
  void advance(Milliseconds step) {
    const auto end = time.now() + step.count();
    while (auto* next = earliest(end)) {
      auto action = std::move(next->action);
      time.set(std::max(time.now(), next->due));
      later_.erase(later_.begin() + (next - later_.data()));
      action();
    }
    time.set(end);
  }

  // The events since the last call, as "Command(param, …)".
  std::vector<std::string> take_events() {
    std::vector<std::string> texts;
    for (auto& event : std::exchange(events, {}))
      texts.push_back(to_string(event).substr(event.source.size() + 1));
    return texts;
  }

  struct Asked {
    Message request;
    Reaction reaction; // for the test to call
  };

  ManualClock time;
  std::vector<Message> events;
  std::vector<Message> sent;
  std::vector<Asked> asked;
  std::vector<std::string> logs;
  std::vector<std::string> failures;
  std::vector<bool> availability; // what available() was told, in order
  std::shared_ptr<const UnderstandingModel> model;
  std::shared_ptr<const PhraseEvaluator> evaluator;
  ColumnReader columns;
  std::string data;
  std::string application;

private:
  struct Later {
    Timestamp due;
    std::function<void()> action;
    DelayId id;
  };

  Later* earliest(Timestamp end) {
    auto next = std::min_element(
        later_.begin(), later_.end(),
        [](const Later& a, const Later& b) { return a.due < b.due; });
    return next == later_.end() || next->due > end ? nullptr : &*next;
  }

  std::vector<Later> later_;
  DelayId last_ = 0;
};

// A message as a session sends it.
inline Message message(std::string command, std::vector<Value> params = {},
                       SessionId session = "s1", Correlation correlation = 7) {
  Message made;
  made.source = "Script";
  made.command = std::move(command);
  made.params = std::move(params);
  made.session = std::move(session);
  made.correlation = correlation;
  return made;
}

} // namespace parlour::test
