#include "tools/parlour/voice_test/kept_component.hpp"

#include <atomic>
#include <set>
#include <utility>

namespace parlour::tools {

namespace {

class StillClock : public Clock {
public:
  Timestamp now() const override {
    return 0;
  }
};

// The host of an instance: passes everything on to the host of the node that it
// works for. Between two nodes nobody hears it. Instances with threads of their
// own may call it at any time.
class ChangingHost : public PluginHost {
public:
  void attach(PluginHost* host) {
    std::lock_guard lock(mutex_);
    host_ = host;
  }
  bool has_failed() const {
    return has_failed_;
  }

  void fire_event(Message event) override {
    with_host([&](PluginHost& host) { host.fire_event(std::move(event)); });
  }
  void send_message(Message message) override {
    with_host([&](PluginHost& host) { host.send_message(std::move(message)); });
  }
  void ask(Message request, Milliseconds patience, Reaction reaction) override {
    with_host([&](PluginHost& host) {
      host.ask(std::move(request), patience, std::move(reaction));
    });
  }
  DelayId after(Milliseconds delay, std::function<void()> action) override {
    DelayId id = 0;
    with_host(
        [&](PluginHost& host) { id = host.after(delay, std::move(action)); });
    return id;
  }
  void cancel(DelayId delay) override {
    with_host([&](PluginHost& host) { host.cancel(delay); });
  }
  void failed(const std::string& reason) override {
    has_failed_ = true;
    with_host([&](PluginHost& host) { host.failed(reason); });
  }
  void available(bool is_available) override {
    with_host([&](PluginHost& host) { host.available(is_available); });
  }
  void log(const std::string& text) override {
    with_host([&](PluginHost& host) { host.log(text); });
  }
  const Clock& clock() const override {
    std::lock_guard lock(mutex_);
    return host_ ? host_->clock() : still_;
  }
  std::shared_ptr<const UnderstandingModel> understanding() const override {
    std::lock_guard lock(mutex_);
    return host_ ? host_->understanding() : nullptr;
  }
  std::shared_ptr<const PhraseEvaluator> phrases() const override {
    std::lock_guard lock(mutex_);
    return host_ ? host_->phrases() : nullptr;
  }
  Expected<std::vector<std::string>>
  column(const std::string& name) const override {
    std::lock_guard lock(mutex_);
    if (host_)
      return host_->column(name);
    return fail(ErrorKind::offline, "no node is there to read " + name);
  }
  std::string data_folder() const override {
    std::lock_guard lock(mutex_);
    return host_ ? host_->data_folder() : "";
  }
  std::string application_folder() const override {
    std::lock_guard lock(mutex_);
    return host_ ? host_->application_folder() : "";
  }

private:
  // The host may not call back: it only queues.
  template <class Action>
  void with_host(const Action& action) {
    std::lock_guard lock(mutex_);
    if (host_)
      action(*host_);
  }

  mutable std::mutex mutex_;
  PluginHost* host_ = nullptr;
  StillClock still_;
  std::atomic<bool> has_failed_ = false;
};

} // namespace

class KeptComponents::Instance {
public:
  explicit Instance(std::unique_ptr<IPlugin> made) : plugin(std::move(made)) {}
  ~Instance() {
    if (has_started)
      plugin->stop();
  }

  ChangingHost host;
  std::unique_ptr<IPlugin> plugin;
  bool has_started = false;
};

// The component of one node, which works by a kept instance.
class GuestComponent : public IPlugin {
public:
  GuestComponent(KeptComponents& kept, std::string component,
                 std::function<std::unique_ptr<IPlugin>()> create,
                 std::vector<Message> forget)
      : kept_(kept), component_(std::move(component)),
        create_(std::move(create)), forget_(std::move(forget)) {}
  ~GuestComponent() override {
    give_back();
  }

  void stop() override {
    give_back();
  }

protected:
  Expected<void> on_start(const Options& options) override {
    take();
    instance_->host.attach(&host());
    if (std::exchange(instance_->has_started, true))
      return {};
    auto started = instance_->plugin->start(instance_->host, options);
    if (!started) {
      instance_->has_started = false;
      instance_->host.attach(nullptr);
      instance_.reset();
    }
    return started;
  }
  void on_message(const Message& message) override {
    sessions_.insert(message.session);
    has_other_values_ |= message.command == "SetValues";
    instance_->plugin->receive(message);
  }

private:
  void take() {
    std::lock_guard lock(kept_.mutex_);
    auto& free = kept_.free_[component_];
    if (free.empty()) {
      instance_ = std::make_unique<KeptComponents::Instance>(create_());
      return;
    }
    instance_ = std::move(free.back());
    free.pop_back();
  }

  void give_back() {
    if (!instance_)
      return;
    instance_->host.attach(nullptr);
    for (const auto& session : sessions_)
      for (auto message : forget_) {
        message.session = session;
        instance_->plugin->receive(message);
      }
    auto instance = std::move(instance_);
    if (instance->host.has_failed() || has_other_values_)
      return;
    std::lock_guard lock(kept_.mutex_);
    kept_.free_[component_].push_back(std::move(instance));
  }

  KeptComponents& kept_;
  const std::string component_;
  std::function<std::unique_ptr<IPlugin>()> create_;
  std::vector<Message> forget_;
  std::unique_ptr<KeptComponents::Instance> instance_;
  std::set<SessionId> sessions_;
  // The next node begins with the values of the seed again.
  bool has_other_values_ = false;
};

KeptComponents::KeptComponents() = default;
KeptComponents::~KeptComponents() = default;

PluginFactory KeptComponents::keep(const std::string& component,
                                   PluginFactory factory,
                                   std::vector<Message> forget) {
  factory.create = [this, component, create = std::move(factory.create),
                    forget = std::move(forget)] {
    return std::make_unique<GuestComponent>(*this, component, create, forget);
  };
  return factory;
}

std::vector<Message> forgetting_of_recognisers() {
  Message cancel;
  cancel.command = "Cancel";
  Message grammar;
  grammar.command = "SetGrammar";
  grammar.params = {Value(List())};
  return {cancel, grammar};
}

} // namespace parlour::tools
