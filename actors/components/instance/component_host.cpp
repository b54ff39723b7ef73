#include "actors/components/instance/component_host.hpp"

#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/actor_trace.hpp"
#include "actors/support/exception_text.hpp"
#include "actors/support/tell_status.hpp"

namespace parlour::actors {

namespace {

using Self = component_host_actor::stateful_pointer<component_host_state>;

// Messages after which others on the same thread get their turn.
// In virtual time, and for components that do not block, several hosts share a
// thread; without a bound a full mailbox would keep the others waiting.
constexpr int max_at_once = 30;
// Where components hand each other much, the next message is a microsecond
// away: to poll so often costs less than to sleep and be woken.
constexpr int polls_before_idle = 8;

// -- calls --------------------------------------------------------------------

// How a call ended. `late`: the supervisor has given the instance up meanwhile.
struct Called {
  enum class How { refused, in_time, late };
  How how = How::refused;
  std::optional<std::string> thrown;

  bool ok() const {
    return how == How::in_time && !thrown;
  }
};

// Calls the plug-in under the eyes of the supervisor, who holds the work while
// it lasts.
template <class Action>
Called call(Self self, Timestamp now, InFlight& work, Action&& action) {
  auto& [parts, instance, trace] = self->state;
  const auto begun = instance->watch.begin(now, work);
  if (begun == CallWatchdog::Begin::refused)
    return {};
  if (begun == CallWatchdog::Begin::unwatched)
    self->send(parts.supervisor, watch_instance{instance->id, true});
  Called called;
  called.thrown = catch_to_string(std::forward<Action>(action));
  called.how =
      instance->watch.end(work) ? Called::How::in_time : Called::How::late;
  return called;
}

// The supervisor decides what follows; this host waits to be stopped.
void report(Self self, const std::string& reason) {
  auto& [parts, instance, trace] = self->state;
  self->send(parts.supervisor,
             component_failed{instance->component->name(), instance->id, reason,
                              parts.time->work.begin()});
}

// The recycled token is dropped: a node with a sleeping component must become
// quiet.
void go_idle(Self self) {
  auto& [parts, instance, trace] = self->state;
  instance->context->drop_recycled();
  if (instance->draining)
    self->send(parts.supervisor,
               instance_idle{instance->id, parts.time->work.begin()});
}

// It was given up meanwhile: nobody waits for it, and another has its place.
void end_late(Self self) {
  auto plugin = self->state.instance->plugin;
  catch_to_string([&] {
    if (plugin)
      plugin->stop();
  });
  self->quit();
}

void judge(Self self, const Called& called) {
  if (called.how == Called::How::late)
    end_late(self);
  else if (called.thrown)
    report(self, *called.thrown);
}

// -- the plug-in's life -------------------------------------------------------

Expected<void> make(Instance& instance) {
  const auto& factory = instance.component->order.factory;
  auto reason = catch_to_string([&] { instance.plugin = factory.create(); });
  if (instance.plugin)
    return {};
  return fail(ErrorKind::settings,
              "was not made: " + reason.value_or("its factory gave none"));
}

Expected<void> bring_up(Instance& instance) {
  if (auto made = make(instance); !made)
    return made;
  return instance.plugin->start(*instance.context,
                                instance.component->order.options);
}

// Making the plug-in counts as part of its start, and one exception of either
// is told as a start that failed.
void start(Self self) {
  auto& [parts, instance, trace] = self->state;
  InFlight expected; // of who waits for the start
  Expected<void> outcome;
  const auto called = call(self, parts.time->now(), expected,
                           [&, &one = *instance] { outcome = bring_up(one); });
  if (called.how != Called::How::in_time)
    return end_late(self);
  if (called.thrown)
    outcome = fail(ErrorKind::settings, *called.thrown);
  self->send(parts.supervisor,
             instance_started{instance->id, std::move(outcome),
                              parts.time->work.begin()});
}

// A plug-in that throws while it stops has stopped; only the log tells of it.
void stop(Self self) {
  auto& [parts, instance, trace] = self->state;
  InFlight expected;
  const auto called =
      call(self, parts.time->now(), expected, [&one = *instance] {
        if (one.plugin)
          one.plugin->stop();
      });
  if (called.how == Called::How::in_time) {
    if (called.thrown)
      parts.observer->log(instance->component->name() +
                          " did not stop well: " + *called.thrown);
    self->send(parts.supervisor,
               instance_stopped{instance->id, parts.time->work.begin()});
  }
  self->quit();
}

// -- its work -----------------------------------------------------------------

// False where it is to take no more. `recycled` is the work of what it is done
// with.
// A call that is refused, as the instance was given up a moment ago, leaves the
// message to another instance.
bool handle(Self self, ComponentMailbox::Job job, InFlight& recycled) {
  auto& [parts, held, trace] = self->state;
  auto& instance = *held;
  const auto& message = *job.message;
  const auto now = parts.time->now();
  if (trace)
    trace.took("message", to_string(message), message.session);
  Called called;
  if (instance.context->gives(message, now, recycled))
    called =
        call(self, now, job.work, [&] { instance.plugin->receive(message); });
  if (called.how == Called::How::refused) {
    instance.component->mailbox->put_back(std::move(job));
    recycled = {};
  } else {
    recycled = std::move(job.work);
  }
  judge(self, called);
  return called.ok();
}

// Polls only where the thread is its own: on a shared thread the messages that
// it waits for could not come meanwhile.
std::optional<ComponentMailbox::Job>
next_job(bool has_thread, ComponentMailbox& mailbox,
         const component_host_actor& host) {
  const int polls = has_thread ? polls_before_idle : 0;
  for (int i = 0; i < polls; ++i) {
    if (auto job = mailbox.take(host, ComponentMailbox::IfEmpty::poll_again))
      return job;
    std::this_thread::yield();
  }
  return mailbox.take(host);
}

// After `max_at_once` it sends itself mailbox_ready, and goes on behind what
// has come for it meanwhile, such as stop_component.
void work(Self self) {
  auto& mailbox = *self->state.instance->component->mailbox;
  const component_host_actor host(self);
  InFlight recycled;
  for (int i = 0; i < max_at_once; ++i) {
    auto job = next_job(self->state.parts.has_thread, mailbox, host);
    if (!job)
      return go_idle(self);
    if (!handle(self, std::move(*job), recycled))
      return mailbox.remove_worker(host);
  }
  self->send(self, mailbox_ready{});
}

std::string doing_of(const Instance& instance) {
  if (instance.draining)
    return "finishes what it has begun";
  return instance.plugin ? "waits" : "has not started";
}

status_told tell_host_status(Self self, const get_status& what) {
  const auto& instance = *self->state.instance;
  const auto& component = *instance.component;
  auto told = tell_status(
      self, what, {component.name(), doing_of(instance), instance.last_error});
  told.status.queue = component.mailbox->size();
  return told;
}

void put_off(Self self, const run_after& what) {
  if (what.delay > Milliseconds::zero())
    self->delayed_send(self, what.delay, run_now{what.due, what.action});
  else
    self->send(self, run_now{what.due, what.action});
}

// The plug-in's own code runs as a call like any other, with a deadline and
// with a token of its own.
void call_back(Self self, const run_now& what) {
  auto& [parts, instance, trace] = self->state;
  if (!instance->context->calls_back(what.due->id()))
    return; // cancelled, or closed
  auto work = parts.time->work.begin();
  const auto called = call(self, parts.time->now(), work, what.action);
  parts.time->due_times.remove(what.due->id());
  if (!called.ok())
    instance->component->mailbox->remove_worker(self);
  judge(self, called);
}

} // namespace

component_host_actor::behavior_type component_host(
    component_host_actor::stateful_pointer<component_host_state> self,
    HostParts parts, std::shared_ptr<Instance> instance) {
  self->state.parts = std::move(parts);
  self->state.instance = std::move(instance);
  self->state.trace =
      ActorTrace(*self->state.parts.observer, component_host_state::name,
                 self->state.instance->component->name());
  return traced<component_host_actor::behavior_type>(
      ActorTrace(self->state.trace),
      [=](const start_component&) { start(self); },
      [=](const mailbox_ready&) { work(self); },
      [=](const run_after& what) { put_off(self, what); },
      [=](const run_now& what) { call_back(self, what); },
      [=](const stop_component&) { stop(self); },
      [=](const get_status& what) { return tell_host_status(self, what); });
}

} // namespace parlour::actors
