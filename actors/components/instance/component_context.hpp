// ComponentContext: the platform as one instance of a plug-in sees it.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <set>

#include <caf/actor_control_block.hpp>

#include "actors/components/instance/plugin_environment.hpp"
#include "actors/routing/message_bus.hpp"
#include "actors/support/instance_scope.hpp"
#include "actors/support/pending_requests.hpp"
#include "actors/support/rate_limiter.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::actors {

// What component contexts are made of.
// All of it outlives the contexts.
struct ContextParts {
  NodeTime& time;
  MessageBus& bus;
  Observer& observer;
  const SharedEnvironment& environment;
  supervisor_actor supervisor = {};
};

// One for each instance, made before its plug-in. What the plug-in fires is
// stamped and routed right here, on the plug-in's thread, and goes into the
// receivers' mailboxes (engine rule 1.1).
// Safe to use from any thread, as PluginHost promises. Outlives its plug-in.
// Once it is closed, whatever the instance still sends or asks for is dropped.
class ComponentContext : public PluginHost,
                         public std::enable_shared_from_this<ComponentContext> {
public:
  // The bounds of architecture rule 5. A question is open until its plug-in has
  // been called back; one too many is refused. Who wants one delay too many
  // counts as broken.
  static constexpr std::size_t max_questions = 10'000;
  static constexpr std::size_t max_delays = 10'000;

  // The component's name, what it says of itself, and which place the instance
  // is for: what it says by itself belongs to the session there.
  ComponentContext(const ContextParts& parts, std::string name,
                   const PluginDescription& description,
                   InstanceId instance = 0,
                   std::shared_ptr<const InstanceScope> scope = nullptr);

  // The actor that calls the plug-in; set before the plug-in starts.
  void belongs_to(const component_host_actor& host);

  // -- who keeps the instance ------------------------------------------------

  // Its plug-in is about to be given this; false where it is closed. `recycled`
  // is kept for what it will say, if that is not there already.
  bool gives(const Message& message, Timestamp now, InFlight& recycled);
  // It is given nothing for now.
  void drop_recycled();
  // It has called back for a delay: false where that was cancelled.
  bool calls_back(DelayId delay);
  // It is to go when it owes no answer any more: then the supervisor is told.
  void drain();
  bool owes_nothing();
  // The messages that it has not answered. It owes no answer to them any more.
  std::vector<Message> take_pending();
  // The same, and it says nothing from now on.
  std::vector<Message> close();
  // Whether its plug-in has asked for what the scripts say of language: it will
  // not notice that they have changed.
  bool has_read_language() const {
    return has_read_language_;
  }

  // -- the plug-in -----------------------------------------------------------

  void fire_event(Message event) override;
  void send_message(Message message) override;
  void ask(Message request, Milliseconds patience, Reaction reaction) override;
  DelayId after(Milliseconds delay, std::function<void()> action) override;
  void cancel(DelayId delay) override;
  void failed(const std::string& reason) override;
  void available(bool is_available) override;
  const Clock& clock() const override;
  void log(const std::string& text) override;
  std::shared_ptr<const UnderstandingModel> understanding() const override;
  std::shared_ptr<const PhraseEvaluator> phrases() const override;
  Expected<std::vector<std::string>>
  column(const std::string& name) const override;
  std::string data_folder() const override;
  std::string application_folder() const override;

private:
  void publish_as_itself(Message&& message);
  // A message that names a session keeps it.
  void fill_session(Message& message) const;
  // `work` takes over what was recycled; it may stay empty.
  bool may_say(Message& message, Timestamp now, InFlight& work);
  // With the lock held.
  std::uint32_t rounds_of_event(Timestamp now) const;
  std::uint32_t rounds_now() const;
  bool may_ask(const Reaction& reaction);
  bool may_wait();
  void reads_language() const;
  // Also after it was closed: the supervisor ignores what comes of an instance
  // that is gone.
  template <class What>
  void tell_supervisor(What what);
  void report_idle();
  std::function<void(Expected<Message>)> caller_back(Reaction reaction);
  void answered();
  DelayId call_back(Milliseconds delay, std::function<void()> action);

  NodeTime& time_;
  MessageBus& bus_;
  Observer& observer_;
  const SharedEnvironment& environment_;
  const supervisor_actor supervisor_;
  const std::string name_;
  const InstanceId instance_;
  const std::shared_ptr<const InstanceScope> scope_; // null: the node
  caf::weak_actor_ptr host_; // weak: the actor holds the plug-in
  mutable std::atomic<bool> has_read_language_ = false;
  mutable std::mutex mutex_; // of what follows
  bool closed_ = false;
  bool draining_ = false;
  bool flooded_ = false;
  RateLimiter rate_limiter_;
  std::uint32_t rounds_ = 0; // of what it was given last, at that time
  Timestamp given_ = 0;
  PendingRequests pending_requests_;
  std::size_t questions_ = 0; // that are open
  // The token of a message that the plug-in has finished. The next event that
  // it fires takes it over: all threads count tokens in one place, so that
  // dropping one and taking another would cost more than anything else here.
  InFlight recycled_;
  // What it has not been called back for yet: CAF's clock holds their messages
  // until they are due, whether there still is a host or not.
  std::set<DelayId> delays_;
};

} // namespace parlour::actors
