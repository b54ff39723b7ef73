#include "adapters/process/process_plugin.hpp"

#include <mutex>
#include <stdexcept>
#include <utility>

#include "adapters/process/frame_values.hpp"

namespace parlour::adapters {

namespace {

// More at a time is a flood.
constexpr std::size_t most_delays = 10'000;

tl::unexpected<Error> not_understood(const Frame& frame) {
  return fail(ErrorKind::network, "its process says what is not understood: " +
                                      std::string(name_of(frame.kind)));
}

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
  Expected<void> meet();
  Expected<Frame> call(FrameKind kind, List fields);
  void is_over(const std::string& reason);
  List start_fields(const Options& options) const;

  // What the process wants.
  Expected<void> take(const Frame& frame);
  Expected<void> pass_on(const Frame& frame);
  Expected<void> ask(const Frame& frame);
  Expected<void> put_off(Id delay, Milliseconds time);
  void cancel(Id delay);
  void run(Id delay);
  Expected<void> answer_column(const Frame& question);
  Expected<void> answer_phrase(const Frame& question);
  Expected<void> reply(const Value& question, const Expected<Value>& answer);

  Value now() const {
    return host().clock().now();
  }

  const ProcessOrder order_;
  std::mutex mutex_;
  std::map<Id, PluginHost::DelayId> delays_; // ours by the process's
  std::unique_ptr<ComponentProcess> process_;
  std::mutex telling_;
  bool told_ = false; // that the process is over
};

// -- calls --------------------------------------------------------------------

Expected<void> ProcessPlugin::on_start(const Options& options) {
  told_ = false;
  process_ = std::make_unique<ComponentProcess>(
      order_, [this](const Frame& frame) { return take(frame); },
      [this](const std::string& line) { host().log("prints: " + line); });
  auto outcome = come_up(options);
  if (!outcome)
    process_.reset();
  return outcome;
}

Expected<void> ProcessPlugin::come_up(const Options& options) {
  if (auto met = meet(); !met)
    return met;
  auto started = process_->call({FrameKind::start, start_fields(options)},
                                order_.start_within);
  if (!started)
    return fail(ErrorKind::settings, started.error().message);
  if (!started->at(0).is_unknown())
    return tl::make_unexpected(error_from(started->at(0)));
  process_->when_over([this](const std::string& reason) { is_over(reason); });
  return {};
}

// Told once, by whoever notices first: the process's thread, or a call. What
// comes after the call may rely on it, so that runs in virtual time are equal.
void ProcessPlugin::is_over(const std::string& reason) {
  std::lock_guard lock(telling_); // the other waits until it is told
  if (!std::exchange(told_, true))
    host().failed(reason);
}

Expected<void> ProcessPlugin::meet() {
  const auto hello = process_->hello(order_.start_within);
  if (!hello)
    return fail(ErrorKind::settings, hello.error().message);
  if (hello->kind == FrameKind::refuse)
    return tl::make_unexpected(error_from(hello->at(0)));
  if (hello->at(0).integer_or(0) == frame_protocol)
    return {};
  return fail(ErrorKind::settings,
              "its process speaks version " + hello->at(0).text() +
                  " of what processes speak, and this program version " +
                  std::to_string(frame_protocol) +
                  "; both have to be of the same build");
}

List ProcessPlugin::start_fields(const Options& options) const {
  // A clock that jumps is told with each call.
  const bool real = dynamic_cast<const SystemClock*>(&host().clock());
  return {now(),
          real,
          to_value(options),
          host().data_folder(),
          host().application_folder(),
          to_value(host().understanding()),
          host().phrases() != nullptr};
}

void ProcessPlugin::on_message(const Message& message) {
  const auto done = call(FrameKind::handle, {now(), to_value(message)});
  // That the process is over was told; whoever waits for an answer is told now.
  if (!done && message.correlation != 0)
    fire_event("Failed", {done.error().message});
}

void ProcessPlugin::run(Id delay) {
  {
    std::lock_guard lock(mutex_);
    if (delays_.erase(delay) == 0)
      return;
  }
  (void)call(FrameKind::run, {now(), delay});
}

// Throws what the plug-in throws, and where the frame is too long. An error:
// the process is over.
Expected<Frame> ProcessPlugin::call(FrameKind kind, List fields) {
  if (!process_)
    return fail(ErrorKind::offline, "it is stopped");
  auto done = process_->call({kind, std::move(fields)}, order_.answer_within);
  if (!done && done.error().kind == ErrorKind::limit)
    throw std::runtime_error(done.error().message);
  if (!done)
    is_over(done.error().message);
  if (done && !done->at(0).is_unknown())
    throw std::runtime_error(done->at(0).text());
  return done;
}

void ProcessPlugin::stop() {
  if (!process_)
    return;
  process_->when_over({});
  const auto stopped =
      process_->call({FrameKind::stop, {now()}}, order_.stop_within);
  if (!stopped)
    host().log("it did not stop well: " + stopped.error().message);
  process_.reset();
  std::lock_guard lock(mutex_);
  for (const auto& [id, delay] : std::exchange(delays_, {}))
    host().cancel(delay);
}

// -- what the process wants ---------------------------------------------------

Expected<void> ProcessPlugin::take(const Frame& frame) {
  switch (frame.kind) {
  case FrameKind::fire:
  case FrameKind::send:
    return pass_on(frame);
  case FrameKind::ask:
    return ask(frame);
  case FrameKind::after:
    return put_off(frame.at(0).integer_or(0),
                   Milliseconds(frame.at(1).integer_or(0)));
  case FrameKind::cancel:
    cancel(frame.at(0).integer_or(0));
    return {};
  case FrameKind::log:
    host().log(frame.at(0).text());
    return {};
  case FrameKind::failed:
    host().failed(frame.at(0).text());
    return {};
  case FrameKind::column:
    return answer_column(frame);
  case FrameKind::phrase:
    return answer_phrase(frame);
  default:
    return not_understood(frame);
  }
}

Expected<void> ProcessPlugin::pass_on(const Frame& frame) {
  auto message = message_from(frame.at(0));
  if (!message)
    return not_understood(frame);
  if (frame.kind == FrameKind::fire)
    host().fire_event(std::move(*message));
  else
    host().send_message(std::move(*message));
  return {};
}

Expected<void> ProcessPlugin::ask(const Frame& frame) {
  auto request = message_from(frame.at(1));
  if (!request)
    return not_understood(frame);
  auto reaction = [this,
                   question = frame.at(0)](const Expected<Message>& answer) {
    (void)call(FrameKind::answer,
               {now(), question, answer ? Value() : to_value(answer.error()),
                answer ? to_value(*answer) : Value()});
  };
  host().ask(std::move(*request), Milliseconds(frame.at(2).integer_or(0)),
             std::move(reaction));
  return {};
}

Expected<void> ProcessPlugin::put_off(Id delay, Milliseconds time) {
  std::lock_guard lock(mutex_); // until it is known, it is not run
  if (delays_.size() >= most_delays)
    return fail(ErrorKind::limit, "its process wants to be called back more "
                                  "than " +
                                      std::to_string(most_delays) +
                                      " times at once");
  delays_[delay] = host().after(time, [this, delay] { run(delay); });
  return {};
}

void ProcessPlugin::cancel(Id delay) {
  std::lock_guard lock(mutex_);
  if (const auto ours = delays_.extract(delay))
    host().cancel(ours.mapped());
}

Expected<void> ProcessPlugin::answer_column(const Frame& question) {
  const auto column = host().column(question.at(1).text());
  if (!column)
    return reply(question.at(0), tl::make_unexpected(column.error()));
  return reply(question.at(0), to_value(*column));
}

Expected<void> ProcessPlugin::answer_phrase(const Frame& question) {
  const auto phrases = host().phrases();
  return reply(
      question.at(0),
      to_value(phrases ? phrases->render(question.at(1)) : Rendering{}));
}

Expected<void> ProcessPlugin::reply(const Value& question,
                                    const Expected<Value>& answer) {
  if (!answer)
    return process_->tell(
        {FrameKind::reply, {question, to_value(answer.error())}});
  auto told = process_->tell({FrameKind::reply, {question, {}, *answer}});
  if (!told && told.error().kind == ErrorKind::limit)
    return reply(question, tl::make_unexpected(told.error()));
  return told;
}

} // namespace

PluginFactory out_of_process(PluginDescription description,
                             ProcessOrder order) {
  description.is_inline = false;
  description.blocks = true; // a call waits for the process
  return {std::move(description),
          [order = std::move(order)]() -> std::unique_ptr<IPlugin> {
            return std::make_unique<ProcessPlugin>(order);
          }};
}

} // namespace parlour::adapters
