// PluginDoor: the platform as one plug-in sees it.
#pragma once

#include <memory>
#include <mutex>

#include <caf/actor_control_block.hpp>

#include "actors/services.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::actors {

// Safe to use from any thread, as its contract says. Outlives its plug-in.
class PluginDoor : public PluginHost,
                   public std::enable_shared_from_this<PluginDoor> {
public:
  PluginDoor(Services& services, std::string name);

  // The actor that calls the plug-in; set before the plug-in starts.
  void belongs_to(const component_host_actor& host);

  void fire_event(Message event) override;
  void send_message(Message message) override;
  void ask(Message request, Milliseconds patience, Reaction reaction) override;
  DelayId after(Milliseconds delay, std::function<void()> action) override;
  void cancel(DelayId delay) override;
  void failed(const std::string& reason) override;
  const Clock& clock() const override;
  void log(const std::string& text) override;
  std::shared_ptr<const UnderstandingModel> understanding() const override;
  std::shared_ptr<const PhraseEvaluator> phrases() const override;
  Expected<std::vector<std::string>>
  column(const std::string& name) const override;
  std::string data_folder() const override;
  std::string application_folder() const override;

private:
  void publish_as_itself(Message message);

  Services& services_;
  const std::string name_;
  caf::weak_actor_ptr host_; // weak: the actor holds the plug-in
};

} // namespace parlour::actors
