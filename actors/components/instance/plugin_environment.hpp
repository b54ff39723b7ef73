// PluginEnvironment: what the plug-ins of a node may know of the application.
// SharedEnvironment: the one that counts now; another takes its place when the
// scripts are changed (engine rule 7.13).
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "actors/support/shared_by_threads.hpp"
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

// From any thread; changed by one at a time. Sessions read it with each phrase,
// so that threads count their pointers apart.
class SharedEnvironment {
public:
  using Pointer = std::shared_ptr<const PluginEnvironment>;

  explicit SharedEnvironment(PluginEnvironment first = {}) {
    change(std::make_shared<const PluginEnvironment>(std::move(first)));
  }

  // Never null.
  Pointer now() const {
    return now_.load();
  }
  void change(const Pointer& to) {
    now_.store(to);
  }

private:
  SharedByThreads<PluginEnvironment> now_;
};

} // namespace parlour::actors
