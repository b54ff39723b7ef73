#include "actors/components/instance/component_context.hpp"

#include <utility>

#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "runtime/message/roles.hpp"

namespace parlour::actors {

namespace {

// Nobody speaks as the platform or as a role (engine rule 1.5).
bool may_speak_as(const std::string& source) {
  return !source.empty() && !find_role(source);
}

} // namespace

ComponentContext::ComponentContext(const ContextParts& parts, std::string name,
                                   const PluginDescription& description,
                                   InstanceId instance,
                                   std::shared_ptr<const InstanceScope> scope)
    : time_(parts.time), bus_(parts.bus), observer_(parts.observer),
      environment_(parts.environment), supervisor_(parts.supervisor),
      name_(std::move(name)), instance_(instance), scope_(std::move(scope)),
      pending_requests_(description.roles, description.events) {}

void ComponentContext::belongs_to(const component_host_actor& host) {
  host_ = caf::actor_cast<caf::weak_actor_ptr>(host);
}

// -- who keeps the instance ---------------------------------------------------

// Each message that it is given pays for some events
// (RateLimiter::each_message): to answer much is no flood.
bool ComponentContext::gives(const Message& message, Timestamp now,
                             InFlight& recycled) {
  std::lock_guard lock(mutex_);
  if (closed_)
    return false;
  rate_limiter_.earn();
  pending_requests_.given(message, now);
  rounds_ = message.rounds;
  given_ = now;
  if (!recycled_)
    std::swap(recycled_, recycled);
  return true;
}

void ComponentContext::drop_recycled() {
  InFlight over; // let go of outside of the lock: it may wake others
  std::lock_guard lock(mutex_);
  std::swap(recycled_, over);
}

bool ComponentContext::calls_back(DelayId delay) {
  std::lock_guard lock(mutex_);
  return delays_.erase(delay) != 0;
}

void ComponentContext::drain() {
  std::lock_guard lock(mutex_);
  draining_ = true;
}

bool ComponentContext::owes_nothing() {
  std::lock_guard lock(mutex_);
  return pending_requests_.none(clock().now());
}

std::vector<Message> ComponentContext::take_pending() {
  std::lock_guard lock(mutex_);
  return pending_requests_.take(clock().now());
}

// The delays' times are removed here and not when CAF's clock comes to them:
// virtual time would stop there for nothing.
std::vector<Message> ComponentContext::close() {
  InFlight over;
  std::unique_lock lock(mutex_);
  closed_ = true;
  std::swap(recycled_, over);
  auto delays = std::exchange(delays_, {});
  auto messages = pending_requests_.take(clock().now());
  lock.unlock();
  for (auto delay : delays)
    time_.due_times.remove(delay);
  return messages;
}

// -- what it says -------------------------------------------------------------

// False where its rate is used up, or it is to say nothing any more.
// The supervisor is told once that it floods; until it is replaced, whatever it
// says is dropped.
bool ComponentContext::may_say(Message& message, Timestamp now,
                               InFlight& work) {
  std::unique_lock lock(mutex_);
  if (closed_ || flooded_)
    return false;
  flooded_ = !rate_limiter_.spend(now);
  if (!flooded_)
    pending_requests_.said(message);
  message.rounds = rounds_of_event(now);
  std::swap(work, recycled_);
  const bool idle = draining_ && pending_requests_.none(now);
  const bool floods = flooded_;
  lock.unlock();
  if (floods)
    failed("it floods the node: more than " +
           std::to_string(RateLimiter::each_second) + " events a second");
  else if (idle)
    report_idle();
  return !floods;
}

// What it says soon after it was given something comes of that.
// A longer time would count a sensor's own events as answers to what it was
// sent last; a shorter one would let slow rings pass (engine rule 1.6).
std::uint32_t ComponentContext::rounds_of_event(Timestamp now) const {
  constexpr Timestamp soon = 100;
  return given_ != 0 && now - given_ <= soon ? rounds_ + 1 : 0;
}

// What is posted may wait in virtual time until the instance and this are gone:
// it brings along all that it needs.
template <class What>
void ComponentContext::tell_supervisor(What what) {
  time_.main_thread.post([supervisor = supervisor_, what = std::move(what)] {
    caf::anon_send(supervisor, what);
  });
}

void ComponentContext::report_idle() {
  tell_supervisor(instance_idle{instance_, time_.work.begin()});
}

// A plug-in may name another component as the source, as a gateway does; it may
// not name a role or the platform.
void ComponentContext::publish_as_itself(Message&& message) {
  const auto now = clock().now();
  InFlight work;
  if (!may_say(message, now, work))
    return;
  if (!may_speak_as(message.source))
    message.source = name_;
  fill_session(message);
  bus_.publish(std::move(message), now, std::move(work));
}

void ComponentContext::fill_session(Message& message) const {
  if (scope_ && message.session.empty())
    message.session = scope_->session();
}

std::uint32_t ComponentContext::rounds_now() const {
  std::lock_guard lock(mutex_);
  return rounds_of_event(clock().now());
}

void ComponentContext::fire_event(Message event) {
  event.sinks.clear();
  publish_as_itself(std::move(event));
}

void ComponentContext::send_message(Message message) {
  publish_as_itself(std::move(message));
}

// False where it is closed, or has too many open: then it hears so as it would
// hear an answer, which is a delay of its own and bounded as such.
bool ComponentContext::may_ask(const Reaction& reaction) {
  std::unique_lock lock(mutex_);
  if (closed_)
    return false;
  if (questions_ < max_questions) {
    ++questions_;
    return true;
  }
  lock.unlock();
  after(Milliseconds::zero(), [reaction] {
    reaction(fail(ErrorKind::limit, "more than " +
                                        std::to_string(max_questions) +
                                        " of its questions are open"));
  });
  return false;
}

// The due time is added at once: until the answer comes, time must not jump
// further.
void ComponentContext::ask(Message request, Milliseconds patience,
                           Reaction reaction) {
  if (!may_ask(reaction))
    return;
  request.source = name_;
  fill_session(request);
  request.rounds = rounds_now();
  const auto id = time_.due_times.add(clock().now() + patience.count(),
                                      DueTimes::Of::component);
  tell_supervisor(ask_component{
      host_, std::move(request), patience, caller_back(std::move(reaction)),
      std::make_shared<const DueTicket>(time_.due_times, id),
      time_.work.begin()});
}

// The plug-in is called on its host's thread, unless it is closed by then.
std::function<void(Expected<Message>)>
ComponentContext::caller_back(Reaction reaction) {
  return [context = weak_from_this(),
          reaction = std::move(reaction)](Expected<Message> outcome) {
    if (auto alive = context.lock())
      alive->call_back(Milliseconds::zero(),
                       [context, reaction, outcome = std::move(outcome)] {
                         if (auto asker = context.lock())
                           asker->answered();
                         reaction(outcome);
                       });
  };
}

void ComponentContext::answered() {
  std::lock_guard lock(mutex_);
  --questions_;
}

void ComponentContext::failed(const std::string& reason) {
  tell_supervisor(
      component_failed{name_, instance_, reason, time_.work.begin()});
}

void ComponentContext::available(bool is_available) {
  tell_supervisor(
      component_available{instance_, is_available, time_.work.begin()});
}

// -- its delays ---------------------------------------------------------------

// False where it has so many already. The supervisor is told once; until it is
// replaced, whatever it says is dropped.
bool ComponentContext::may_wait() {
  std::unique_lock lock(mutex_);
  if (delays_.size() < max_delays)
    return true;
  const bool is_told = std::exchange(flooded_, true);
  lock.unlock();
  if (!is_told)
    failed("it wants to be called back more than " +
           std::to_string(max_delays) + " times at once");
  return false;
}

PluginHost::DelayId ComponentContext::after(Milliseconds delay,
                                            std::function<void()> action) {
  constexpr DelayId none = 0;
  return may_wait() ? call_back(delay, std::move(action)) : none;
}

// The message holds the ticket, so that the due time ends with it, if the host
// is gone by then.
PluginHost::DelayId ComponentContext::call_back(Milliseconds delay,
                                                std::function<void()> action) {
  const auto id = time_.due_times.add(clock().now() + delay.count(),
                                      DueTimes::Of::component);
  auto due = std::make_shared<const DueTicket>(time_.due_times, id);
  std::unique_lock lock(mutex_);
  if (closed_)
    return id; // which goes with its ticket
  delays_.insert(id);
  lock.unlock();
  auto order = [to = host_, delay, due = std::move(due),
                action = std::move(action), work = time_.work.begin()] {
    if (auto host = caf::actor_cast<caf::strong_actor_ptr>(to))
      caf::anon_send(caf::actor_cast<component_host_actor>(host),
                     run_after{delay, due, action, work});
  };
  time_.main_thread.post(std::move(order));
  return id;
}

// The message comes all the same, and calls_back() finds that it was cancelled.
void ComponentContext::cancel(DelayId delay) {
  {
    std::lock_guard lock(mutex_);
    delays_.erase(delay);
  }
  time_.due_times.remove(delay);
}

// -- what it asks for ---------------------------------------------------------

const Clock& ComponentContext::clock() const {
  return time_.clock;
}

void ComponentContext::log(const std::string& text) {
  observer_.log(name_ + ": " + text);
}

// Written once: several threads may ask for phrases, again and again.
void ComponentContext::reads_language() const {
  if (!has_read_language_)
    has_read_language_ = true;
}

std::shared_ptr<const UnderstandingModel>
ComponentContext::understanding() const {
  reads_language();
  return environment_.now()->understanding;
}

std::shared_ptr<const PhraseEvaluator> ComponentContext::phrases() const {
  reads_language();
  return environment_.now()->phrases;
}

Expected<std::vector<std::string>>
ComponentContext::column(const std::string& name) const {
  const auto environment = environment_.now();
  if (environment->columns)
    return environment->columns(name);
  return fail(ErrorKind::database, "nobody reads the column " + name);
}

std::string ComponentContext::data_folder() const {
  return environment_.now()->data_folder;
}

std::string ComponentContext::application_folder() const {
  return environment_.now()->application_folder;
}

} // namespace parlour::actors
