// PluginEnvironment: what the plug-ins of a node may know of the application;
// const once the node has started.
#pragma once

#include <memory>
#include <string>

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

} // namespace parlour::actors
