// KeptComponents: instances of a plug-in that outlive the node that they work
// for, and go on in the next one. A recogniser takes seconds to start, and a
// test has many nodes.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// Thread-safe. It outlives the nodes. All instances of one component have the
// same options: keep those of one application.
class KeptComponents {
public:
  KeptComponents();
  KeptComponents(const KeptComponents&) = delete;
  KeptComponents& operator=(const KeptComponents&) = delete;
  ~KeptComponents();

  // Makes components of this name that work by an instance that is free, or by
  // a new one. When its node stops, the instance forgets the sessions: `forget`
  // is sent to it for each. One that has failed, or got new values of a column,
  // is not kept.
  PluginFactory keep(const std::string& component, PluginFactory factory,
                     std::vector<Message> forget);

  class Instance; // internal

private:
  std::mutex mutex_;
  // By the names of their components.
  std::map<std::string, std::vector<std::unique_ptr<Instance>>> free_;

  friend class GuestComponent;
};

// What makes a recogniser forget a session.
std::vector<Message> forgetting_of_recognisers();

} // namespace parlour::tools
