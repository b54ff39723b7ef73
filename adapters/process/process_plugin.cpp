// Threads: the component's supervisor calls the plug-in on one thread. Messages
// of the process are taken on that thread during a call, and on the thread of
// ComponentProcess between calls; PluginHost may be called from both.
#include "adapters/process/process_plugin.hpp"

#include <mutex>
#include <stdexcept>
#include <utility>

#include "adapters/process/ipc_values.hpp"

namespace parlour::adapters {

namespace {

// Bounds the timers that a broken component can start.
constexpr std::size_t max_delays = 10'000;

tl::unexpected<Error> not_understood(const IpcMessage& message) {
  return fail(ErrorKind::network, "its process says what is not understood: " +
                                      std::string(name_of(message.kind)));
}

// Answers a question. An answer that is too long is replaced by the error.
Expected<void> reply(ComponentProcess& process, const IpcMessage& question,
                     const Expected<Value>& answer) {
  const auto& number = question.at(0);
  if (!answer)
    return process.tell({IpcKind::reply, {number, to_value(answer.error())}});
  auto told = process.tell({IpcKind::reply, {number, {}, *answer}});
  if (!told && told.error().kind == ErrorKind::limit)
    return reply(process, question, tl::make_unexpected(told.error()));
  return told;
}

// The platform's side. Calls of the supervisor become messages to the process;
// messages of the process become calls of the host (take).
class ProcessPlugin : public IPlugin {
public:
  explicit ProcessPlugin(ProcessOrder order) : order_(std::move(order)) {}

  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;
  void on_message(const Message& message) override;

private:
  using Id = std::int64_t;

  Expected<void> come_up(const Options& options);
  // The handshake: the protocol versions must be equal.
  Expected<void> meet();
  Expected<IpcMessage> call(IpcKind kind, List fields);
  void report_failure(const std::string& reason);
  List start_fields(const Options& options) const;

  // Carries out what the process wants.
  Expected<void> take(ComponentProcess& process, const IpcMessage& message);
  Expected<void> pass_on(const IpcMessage& message);
  Expected<void> ask(const IpcMessage& message);
  Expected<void> put_off(Id delay, Milliseconds time);
  void cancel(Id delay);
  void run(Id delay);
  Expected<Value> column(const std::string& name) const;
  Value language() const;
  Value phrase(const Value& say) const;

  Value now() const {
    return host().clock().now();
  }

  const ProcessOrder order_;
  std::mutex mutex_;
  // The host's timers by the numbers that the process gave them.
  std::map<Id, PluginHost::DelayId> delays_;
  std::mutex telling_;
  // Whether the host knows that the component has failed.
  bool told_ = false;
  // For calls: only the calling thread may look at it, because the thread of
  // the process may still be in take() when it is null. The last member: that
  // thread uses all others.
  std::unique_ptr<ComponentProcess> process_;
};

// -- calls --------------------------------------------------------------------

Expected<void> ProcessPlugin::on_start(const Options& options) {
  told_ = false;
  process_ = std::make_unique<ComponentProcess>(
      order_,
      [this](ComponentProcess& process, const IpcMessage& message) {
        return take(process, message);
      },
      [this](const std::string& line) { host().log("prints: " + line); });
  auto outcome = come_up(options);
  if (!outcome)
    process_.reset();
  return outcome;
}

// From when_over on, the end of the process is a failure; before, it is an
// error of the start.
Expected<void> ProcessPlugin::come_up(const Options& options) {
  if (auto met = meet(); !met)
    return met;
  auto started = process_->call({IpcKind::start, start_fields(options)},
                                order_.start_within);
  if (!started)
    return fail(ErrorKind::settings, started.error().message);
  if (!started->at(0).is_unknown())
    return tl::make_unexpected(error_from(started->at(0)));
  process_->when_over(
      [this](const std::string& reason) { report_failure(reason); });
  return {};
}

// Reports a failure once, for whoever notices it first: the plug-in itself, the
// process's thread or a call. The end of a process that said that it has failed
// is no second failure. The lock makes the second one wait until it has been
// reported, so that what follows a call sees the same in every run in virtual
// time.
void ProcessPlugin::report_failure(const std::string& reason) {
  std::lock_guard lock(telling_);
  if (!std::exchange(told_, true))
    host().failed(reason);
}

Expected<void> ProcessPlugin::meet() {
  const auto hello = process_->hello(order_.start_within);
  if (!hello)
    return fail(ErrorKind::settings, hello.error().message);
  if (hello->kind == IpcKind::refuse)
    return tl::make_unexpected(error_from(hello->at(0)));
  if (hello->at(0).integer_or(0) == ipc_protocol)
    return {};
  return fail(ErrorKind::settings,
              "its process speaks version " + hello->at(0).text() +
                  " of what processes speak, and this program version " +
                  std::to_string(ipc_protocol) +
                  "; both have to be of the same build");
}

List ProcessPlugin::start_fields(const Options& options) const {
  // The process reads a real clock itself. A virtual clock is told with each
  // call.
  const bool real = dynamic_cast<const SystemClock*>(&host().clock());
  return {now(), real, to_value(options), host().data_folder(),
          host().application_folder()};
}

void ProcessPlugin::on_message(const Message& message) {
  const auto done = call(IpcKind::handle, {now(), to_value(message)});
  // report_failure() has told the end of the process. Whoever waits for the
  // answer to this message gets an answer, too.
  if (!done && message.correlation != 0)
    fire_event("Failed", {done.error().message});
}

void ProcessPlugin::run(Id delay) {
  {
    std::lock_guard lock(mutex_);
    if (delays_.erase(delay) == 0)
      return;
  }
  (void)call(IpcKind::run, {now(), delay});
}

// Throws what the plug-in threw, and an error if the message is too long, so
// that the supervisor sees the same exception as without a process. An error as
// result means that the process has ended.
Expected<IpcMessage> ProcessPlugin::call(IpcKind kind, List fields) {
  if (!process_)
    return fail(ErrorKind::offline, "it is stopped");
  auto done = process_->call({kind, std::move(fields)}, order_.answer_within);
  if (!done && done.error().kind == ErrorKind::limit)
    throw std::runtime_error(done.error().message);
  if (!done)
    report_failure(done.error().message);
  if (done && !done->at(0).is_unknown())
    throw std::runtime_error(done->at(0).text());
  return done;
}

// The end of the process is wanted from here on, so it is no failure.
void ProcessPlugin::stop() {
  if (!process_)
    return;
  process_->when_over({});
  const auto stopped =
      process_->call({IpcKind::stop, {now()}}, order_.stop_within);
  if (!stopped)
    host().log("it did not stop well: " + stopped.error().message);
  process_.reset();
  std::lock_guard lock(mutex_);
  for (const auto& [id, delay] : std::exchange(delays_, {}))
    host().cancel(delay);
}

// -- what the process wants ---------------------------------------------------

Expected<void> ProcessPlugin::take(ComponentProcess& process,
                                   const IpcMessage& message) {
  switch (message.kind) {
  case IpcKind::fire:
  case IpcKind::send:
    return pass_on(message);
  case IpcKind::ask:
    return ask(message);
  case IpcKind::after:
    return put_off(message.at(0).integer_or(0),
                   Milliseconds(message.at(1).integer_or(0)));
  case IpcKind::cancel:
    cancel(message.at(0).integer_or(0));
    return {};
  case IpcKind::log:
    host().log(message.at(0).text());
    return {};
  case IpcKind::failed:
    report_failure(message.at(0).text());
    return {};
  case IpcKind::available:
    host().available(message.at(0) == Value(true));
    return {};
  case IpcKind::column:
    return reply(process, message, column(message.at(1).text()));
  case IpcKind::language:
    return reply(process, message, language());
  case IpcKind::phrase:
    return reply(process, message, phrase(message.at(1)));
  default:
    return not_understood(message);
  }
}

Expected<void> ProcessPlugin::pass_on(const IpcMessage& message) {
  auto content = message_from(message.at(0));
  if (!content)
    return not_understood(message);
  if (message.kind == IpcKind::fire)
    host().fire_event(std::move(*content));
  else
    host().send_message(std::move(*content));
  return {};
}

Expected<void> ProcessPlugin::ask(const IpcMessage& message) {
  auto request = message_from(message.at(1));
  if (!request)
    return not_understood(message);
  auto reaction = [this,
                   question = message.at(0)](const Expected<Message>& answer) {
    (void)call(IpcKind::answer,
               {now(), question, answer ? Value() : to_value(answer.error()),
                answer ? to_value(*answer) : Value()});
  };
  host().ask(std::move(*request), Milliseconds(message.at(2).integer_or(0)),
             std::move(reaction));
  return {};
}

Expected<void> ProcessPlugin::put_off(Id delay, Milliseconds time) {
  // The lock is held until the timer is recorded: run() cannot miss it.
  std::lock_guard lock(mutex_);
  if (delays_.size() >= max_delays)
    return fail(ErrorKind::limit, "its process wants to be called back more "
                                  "than " +
                                      std::to_string(max_delays) +
                                      " times at once");
  delays_[delay] = host().after(time, [this, delay] { run(delay); });
  return {};
}

void ProcessPlugin::cancel(Id delay) {
  std::lock_guard lock(mutex_);
  if (const auto ours = delays_.extract(delay))
    host().cancel(ours.mapped());
}

Expected<Value> ProcessPlugin::column(const std::string& name) const {
  return host().column(name).map(
      [](const std::vector<std::string>& values) { return to_value(values); });
}

// Only when it is asked for: whoever has read it is started anew when the
// scripts change (Supervision::change).
Value ProcessPlugin::language() const {
  return List{to_value(host().understanding()), host().phrases() != nullptr};
}

Value ProcessPlugin::phrase(const Value& say) const {
  const auto phrases = host().phrases();
  return to_value(phrases ? phrases->render(say) : Rendering{});
}

} // namespace

PluginFactory out_of_process(PluginDescription description,
                             ProcessOrder order) {
  // Calls wait for the process.
  description.is_inline = false;
  description.blocks = true;
  return {std::move(description),
          [order = std::move(order)]() -> std::unique_ptr<IPlugin> {
            return std::make_unique<ProcessPlugin>(order);
          }};
}

} // namespace parlour::adapters
