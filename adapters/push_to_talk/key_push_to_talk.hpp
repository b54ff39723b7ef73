// KeyPushToTalk is a plug-in for the role PushToTalk: a key of an input device
// of the kernel, or of the terminal.
//
//  Enable, Disable   whether the key counts; it does unless told otherwise
//
// It fires Pressed when somebody begins to talk and Released when they stop,
// in turn: Pressed is always followed by Released, also when the device is lost
// or the key disabled.
//
// Options: device (none: the terminal), key, press (hold or twice). A device
// that is gone makes the component unavailable, and it is tried again every
// second.
//
// Threads: a loop of its own reads the key; events come from there.
#pragma once

#include <memory>

#include "runtime/base/clock.hpp"
#include "runtime/plugin/role_plugin.hpp"

namespace parlour::adapters {

class KeyPushToTalk : public RolePlugin {
public:
  // `retry` is how long to wait before a lost device is opened again.
  explicit KeyPushToTalk(Milliseconds retry);
  ~KeyPushToTalk() override;

  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;

private:
  class Keyboard;

  void on_enable();
  void on_disable();
  // Called on the loop's thread.
  void talks(bool talks);
  void lost();
  void found();

  const Milliseconds retry_;
  std::unique_ptr<Keyboard> keyboard_; // null: not started
};

// The time is for tests.
PluginFactory
key_push_to_talk_factory(Milliseconds retry = Milliseconds(1'000));

// The same where no device may be touched: a key that nobody presses.
PluginFactory unpressed_key_factory();

} // namespace parlour::adapters
