// KeptComponents: instances of a plug-in that outlive the node that they work
// for, and go on in the next one. A recogniser takes seconds to start, and a
// test has many nodes.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// Thread-safe. It outlives the nodes. All instances have the same options: keep
// those of one component of one application.
class KeptComponents {
public:
  KeptComponents();
  KeptComponents(const KeptComponents&) = delete;
  KeptComponents& operator=(const KeptComponents&) = delete;
  ~KeptComponents();

  // Makes components that work by an instance that is free, or by a new one.
  // When its node stops, the instance forgets the sessions: `forget` is sent to
  // it for each. One that has failed is not kept.
  PluginFactory keep(PluginFactory factory, std::vector<Message> forget);

  class Instance; // internal

private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Instance>> free_;

  friend class GuestComponent;
};

// What makes a recogniser forget a session.
std::vector<Message> forgetting_of_recognisers();

} // namespace parlour::tools
