// PlayoutSpeaker is what the plug-ins of the role Speaker have in common:
// commands go to a Playout, and its events are fired.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "adapters/audio/playout.hpp"
#include "runtime/plugin/role_plugin.hpp"

namespace parlour::adapters {

class PlayoutSpeaker : public RolePlugin {
protected:
  PlayoutSpeaker();

  // Why nothing can be played now; asked before each command, under the lock of
  // the playout.
  virtual Expected<void> ready() {
    return {};
  }
  // A command has changed what is played. Called on the plug-in's own thread,
  // without the lock.
  virtual void changed() = 0;

  // Does something with the playout under its lock. Thread-safe.
  template <class Action>
  auto with_playout(Action action) {
    std::lock_guard lock(mutex_);
    return action(playout_);
  }
  // Fires the events. Thread-safe.
  void tell(const std::vector<PlayoutEvent>& events);

private:
  void on_play(const Value& audio, std::int64_t utterance);
  void on_mark(std::int64_t utterance, const std::string& word,
               std::int64_t position);
  void on_finish(std::int64_t utterance);
  void on_stop(std::optional<std::int64_t> utterance);

  // Gives the message being handled to the playout; refuses it where that
  // returns an error.
  template <class Action>
  void order(Action action);

  std::mutex mutex_;
  Playout playout_;
};

} // namespace parlour::adapters
