// PluginEnvironment: what the plug-ins of a node may know of the application.
// SharedEnvironment: the one that counts now; another takes its place when the
// scripts are changed (engine rule 7.13).
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <utility>

#include "runtime/message/phrases.hpp"
#include "runtime/message/understanding.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::actors {

struct PluginEnvironment {
  std::shared_ptr<const PhraseEvaluator> phrases = nullptr;
  std::shared_ptr<const UnderstandingModel> understanding = nullptr;
  ColumnReader columns = {};    // may be empty
  std::string data_folder = {}; // absolute, writable
  std::string application_folder = {};
};

// From any thread. Plug-ins that are rarely asked read it, so that one place is
// enough for all threads.
class SharedEnvironment {
public:
  using Pointer = std::shared_ptr<const PluginEnvironment>;

  explicit SharedEnvironment(PluginEnvironment first = {})
      : now_(std::make_shared<const PluginEnvironment>(std::move(first))) {}

  // Never null.
  Pointer now() const {
    return now_.load();
  }
  void change(Pointer to) {
    now_.store(std::move(to));
  }

private:
  std::atomic<Pointer> now_;
};

} // namespace parlour::actors
