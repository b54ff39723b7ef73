#include "actors/components/plugin_door.hpp"

#include <utility>

#include <caf/actor_system.hpp>
#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/components/ask.hpp"
#include "runtime/base/roles.hpp"

namespace parlour::actors {

namespace {

// Nobody speaks as the platform or as a role (engine rule 1.5).
bool may_speak_as(const std::string& source) {
  return !source.empty() && !find_role(source);
}

} // namespace

PluginDoor::PluginDoor(const DoorParts& parts, std::string name,
                       const PluginDescription& description,
                       InstanceId instance, std::shared_ptr<const Place> place)
    : time_(parts.time), bus_(parts.bus), observer_(parts.observer),
      environment_(parts.environment), supervisor_(parts.supervisor),
      name_(std::move(name)), instance_(instance), place_(std::move(place)),
      unanswered_(description.roles, description.events) {}

void PluginDoor::belongs_to(const component_host_actor& host) {
  host_ = caf::actor_cast<caf::weak_actor_ptr>(host);
}

// -- who keeps the instance ---------------------------------------------------

bool PluginDoor::gives(const Message& message, Timestamp now, Work& spare) {
  std::lock_guard lock(mutex_);
  if (closed_)
    return false;
  credit_.earn();
  unanswered_.given(message, now);
  rounds_ = message.rounds;
  given_ = now;
  if (!spare_)
    std::swap(spare_, spare);
  return true;
}

void PluginDoor::drop_spare() {
  Work over; // let go of outside of the lock: it may wake others
  std::lock_guard lock(mutex_);
  std::swap(spare_, over);
}

bool PluginDoor::calls_back(DelayId delay) {
  std::lock_guard lock(mutex_);
  return delays_.erase(delay) != 0;
}

void PluginDoor::leaves() {
  std::lock_guard lock(mutex_);
  leaves_ = true;
}

bool PluginDoor::is_closed() const {
  std::lock_guard lock(mutex_);
  return closed_;
}

bool PluginDoor::owes_nothing() {
  std::lock_guard lock(mutex_);
  return unanswered_.none(clock().now());
}

std::vector<Message> PluginDoor::close() {
  Work over;
  std::unique_lock lock(mutex_);
  closed_ = true;
  std::swap(spare_, over);
  auto delays = std::exchange(delays_, {});
  auto messages = unanswered_.take(clock().now());
  lock.unlock();
  for (auto delay : delays)
    time_.due_times.remove(delay);
  return messages;
}

// -- what it says -------------------------------------------------------------

// False where its credit is used up, or it is to say nothing any more.
bool PluginDoor::may_say(Message& message, Timestamp now, Work& work) {
  std::unique_lock lock(mutex_);
  if (closed_ || flooded_)
    return false;
  flooded_ = !credit_.spend(now);
  if (!flooded_)
    unanswered_.said(message);
  message.rounds = rounds_of_event(now);
  std::swap(work, spare_);
  const bool rests = leaves_ && unanswered_.none(now);
  const bool floods = flooded_;
  lock.unlock();
  if (floods)
    failed("it floods the house: more than " +
           std::to_string(EventCredit::each_second) + " events a second");
  else if (rests)
    tell_supervisor_of_rest();
  return !floods;
}

// What it says soon after it was given something comes of that.
std::uint32_t PluginDoor::rounds_of_event(Timestamp now) const {
  constexpr Timestamp soon = 100;
  return given_ != 0 && now - given_ <= soon ? rounds_ + 1 : 0;
}

void PluginDoor::tell_supervisor_of_rest() {
  auto tell = [this, work = time_.work.begin()] {
    caf::anon_send(supervisor_, instance_rests{instance_, work});
  };
  time_.gate.enter(std::move(tell));
}

void PluginDoor::publish_as_itself(Message&& message) {
  const auto now = clock().now();
  Work work;
  if (!may_say(message, now, work))
    return;
  if (!may_speak_as(message.source))
    message.source = name_;
  fill_session(message);
  bus_.publish(std::move(message), now, std::move(work));
}

void PluginDoor::fill_session(Message& message) const {
  if (place_ && message.session.empty())
    message.session = place_->session();
}

std::uint32_t PluginDoor::rounds_now() const {
  std::lock_guard lock(mutex_);
  return rounds_of_event(clock().now());
}

void PluginDoor::fire_event(Message event) {
  event.sinks.clear();
  publish_as_itself(std::move(event));
}

void PluginDoor::send_message(Message message) {
  publish_as_itself(std::move(message));
}

void PluginDoor::ask(Message request, Milliseconds patience,
                     Reaction reaction) {
  if (is_closed())
    return;
  request.source = name_;
  fill_session(request);
  request.rounds = rounds_now();
  const auto id = time_.due_times.add(clock().now() + patience.count(),
                                      DueTimes::Of::component);
  AskOrder order{std::move(request),
                 patience,
                 std::move(reaction),
                 weak_from_this(),
                 std::make_shared<const DueTicket>(time_.due_times, id),
                 time_.work.begin()};
  time_.gate.enter([this, order = std::move(order)] {
    if (auto host = caf::actor_cast<caf::strong_actor_ptr>(host_))
      host->home_system->spawn(actors::ask, &bus_,
                               caf::actor_cast<component_host_actor>(host),
                               order);
  });
}

void PluginDoor::failed(const std::string& reason) {
  auto tell = [this, reason, work = time_.work.begin()] {
    caf::anon_send(supervisor_,
                   component_failed{name_, instance_, reason, work});
  };
  time_.gate.enter(std::move(tell));
}

// -- its delays ---------------------------------------------------------------

PluginHost::DelayId PluginDoor::after(Milliseconds delay,
                                      std::function<void()> action) {
  const auto id = time_.due_times.add(clock().now() + delay.count(),
                                      DueTimes::Of::component);
  auto due = std::make_shared<const DueTicket>(time_.due_times, id);
  std::unique_lock lock(mutex_);
  if (closed_)
    return id; // which goes with its ticket
  delays_.insert(id);
  lock.unlock();
  auto order = [this, delay, due = std::move(due), action = std::move(action),
                work = time_.work.begin()] {
    if (auto host = caf::actor_cast<caf::strong_actor_ptr>(host_))
      caf::anon_send(caf::actor_cast<component_host_actor>(host),
                     run_after{delay, due, action, work});
  };
  time_.gate.enter(std::move(order));
  return id;
}

void PluginDoor::cancel(DelayId delay) {
  {
    std::lock_guard lock(mutex_);
    delays_.erase(delay);
  }
  time_.due_times.remove(delay);
}

// -- what it asks for ---------------------------------------------------------

const Clock& PluginDoor::clock() const {
  return time_.clock;
}

void PluginDoor::log(const std::string& text) {
  observer_.log(name_ + ": " + text);
}

std::shared_ptr<const UnderstandingModel> PluginDoor::understanding() const {
  return environment_.understanding;
}

std::shared_ptr<const PhraseEvaluator> PluginDoor::phrases() const {
  return environment_.phrases;
}

Expected<std::vector<std::string>>
PluginDoor::column(const std::string& name) const {
  if (environment_.columns)
    return environment_.columns(name);
  return fail(ErrorKind::database, "nobody reads the column " + name);
}

std::string PluginDoor::data_folder() const {
  return environment_.data_folder;
}

std::string PluginDoor::application_folder() const {
  return environment_.application_folder;
}

} // namespace parlour::actors
