// PluginAgent runs a plug-in as a remote agent: `parlour agent`. The plug-in
// needs no change; a component that may crash can live in a process of its own,
// on another computer.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "adapters/agents/client/agent_connection.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::agents {

struct PluginAgentOrder {
  std::string name; // the agent's
  std::string token;
  PlatformAddress address;
  PluginFactory factory;
  Options options;
  std::string data_folder;
  // Gets lines about the connection and those of the plug-in, on any thread.
  std::function<void(const std::string& line)> log;
};

class PluginAgent {
public:
  explicit PluginAgent(PluginAgentOrder order);
  ~PluginAgent();

  // Starts the plug-in on the calling thread and calls it there until the end.
  // Returns without an error after stop(). The error says that the plug-in does
  // not start, threw or has failed, or that the platform does not want it.
  Expected<void> run();
  // Ends run(); safe from any thread, also before it.
  void stop();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace parlour::adapters::agents
