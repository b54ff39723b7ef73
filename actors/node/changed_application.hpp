// ChangedApplication: what the application of a running node is changed to, and
// what that has led to (engine rule 7.13).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "actors/protocol/component_order.hpp"
#include "actors/protocol/reload.hpp"
#include "runtime/message/phrases.hpp"
#include "runtime/message/understanding.hpp"
#include "runtime/plugin/plugin.hpp"
#include "script/program/program.hpp"

namespace parlour::actors {

// These options (node_options.hpp) in the place of those that the node was
// started with. All others stay.
struct ChangedApplication {
  std::shared_ptr<const script::Program> program;
  std::vector<ComponentOrder> components;
  std::shared_ptr<const PhraseEvaluator> phrases;
  std::shared_ptr<const UnderstandingModel> understanding; // null: program's
  ColumnReader columns;
};

struct ReloadOutcome {
  ReloadedSessions sessions;
  std::vector<std::string> loaded;   // components, anew or again
  std::vector<std::string> unloaded; // the settings do not name them any more
};

} // namespace parlour::actors
