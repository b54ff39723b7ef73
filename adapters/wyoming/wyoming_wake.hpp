// WyomingWake is a plug-in for the role KeywordSpotter that has words found by
// a server of the Wyoming protocol, such as openWakeWord.
//
//  Process(audio, position?)
//      Goes to the server over a connection of the session's own. Keyword(text,
//      unknown, position) when the server has found one: position as Process
//      has it, or in ms since the session's first audio. Failed(reason): the
//      server does not listen; it is tried again.
//  SetKeywords(list)
//      Only these are looked for from now on, in all sessions.
//
// Options: those of client.hpp; keywords, separated by commas.
#pragma once

#include <memory>
#include <optional>

#include "runtime/plugin/role_plugin.hpp"

namespace parlour::adapters {

// A session has one stream that never ends; nothing is answered one by one.
class WyomingWake : public RolePlugin {
public:
  WyomingWake();
  ~WyomingWake() override;
  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;

private:
  class Streams;

  void on_process(const Binary& audio, std::optional<std::int64_t> position);
  void on_set_keywords(const List& words);

  std::unique_ptr<Streams> streams_;
};

PluginFactory wyoming_wake_factory();

} // namespace parlour::adapters
