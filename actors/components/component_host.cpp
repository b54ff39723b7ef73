#include "actors/components/component_host.hpp"

#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/thrown.hpp"

namespace parlour::actors {

namespace {

using Self = component_host_actor::stateful_pointer<component_host_state>;

// Messages after which others on the same thread get their turn.
constexpr int most_at_once = 30;
// Where components hand each other much, the next message is a microsecond
// away: to look again so often costs less than to sleep and be woken.
constexpr int looks_before_rest = 8;

// -- calls --------------------------------------------------------------------

struct Called {
  enum class How { refused, in_time, late };
  How how = How::refused;
  std::optional<std::string> thrown;

  bool well() const {
    return how == How::in_time && !thrown;
  }
};

// Calls the plug-in under the eyes of the supervisor, who holds the work while
// it lasts.
template <class Action>
Called call(Self self, Timestamp now, Work& work, Action&& action) {
  auto& [parts, instance] = self->state;
  const auto begun = instance->watch.begin(now, work);
  if (begun == CallWatch::Begin::refused)
    return {};
  if (begun == CallWatch::Begin::unwatched)
    self->send(parts.supervisor, watch_instance{instance->id, true});
  Called called;
  called.thrown = thrown_by(std::forward<Action>(action));
  called.how =
      instance->watch.end(work) ? Called::How::in_time : Called::How::late;
  return called;
}

void report(Self self, const std::string& reason) {
  auto& [parts, instance] = self->state;
  self->send(parts.supervisor,
             component_failed{instance->component->name(), instance->id, reason,
                              parts.time->work.begin()});
}

void rest(Self self) {
  auto& [parts, instance] = self->state;
  instance->door->drop_spare();
  if (instance->leaves)
    self->send(parts.supervisor,
               instance_rests{instance->id, parts.time->work.begin()});
}

// It was given up meanwhile: nobody waits for it, and another has its place.
void end_late(Self self) {
  auto plugin = self->state.instance->plugin;
  thrown_by([&] {
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
  auto reason = thrown_by([&] { instance.plugin = factory.create(); });
  if (instance.plugin)
    return {};
  return fail(ErrorKind::settings,
              "was not made: " + reason.value_or("its factory gave none"));
}

Expected<void> bring_up(Instance& instance) {
  if (auto made = make(instance); !made)
    return made;
  return instance.plugin->start(*instance.door,
                                instance.component->order.options);
}

void start(Self self) {
  auto& [parts, instance] = self->state;
  Work expected; // of who waits for the start
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

void stop(Self self) {
  auto& [parts, instance] = self->state;
  Work expected;
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

// False where it is to take no more. `spare` is the work of what it is done
// with.
bool handle(Self self, ComponentMailbox::Job job, Work& spare) {
  auto& [parts, held] = self->state;
  auto& instance = *held;
  const auto& message = *job.message;
  const auto now = parts.time->now();
  Called called;
  if (instance.door->gives(message, now, spare))
    called =
        call(self, now, job.work, [&] { instance.plugin->receive(message); });
  if (called.how == Called::How::refused)
    instance.component->mailbox->put_back(std::move(job));
  spare = std::move(job.work);
  judge(self, called);
  return called.well();
}

std::optional<ComponentMailbox::Job>
next_job(bool has_thread, ComponentMailbox& mailbox,
         const component_host_actor& host) {
  const int looks = has_thread ? looks_before_rest : 0;
  for (int look = 0; look < looks; ++look) {
    if (auto job = mailbox.take(host, ComponentMailbox::IfEmpty::look_again))
      return job;
    std::this_thread::yield();
  }
  return mailbox.take(host);
}

void work(Self self) {
  auto& mailbox = *self->state.instance->component->mailbox;
  const component_host_actor host(self);
  Work spare;
  for (int i = 0; i < most_at_once; ++i) {
    auto job = next_job(self->state.parts.has_thread, mailbox, host);
    if (!job)
      return rest(self);
    if (!handle(self, std::move(*job), spare))
      return mailbox.leave(host);
  }
  self->send(self, work_waits{});
}

void put_off(Self self, const run_after& what) {
  if (what.delay > Milliseconds::zero())
    self->delayed_send(self, what.delay, run_now{what.due, what.action});
  else
    self->send(self, run_now{what.due, what.action});
}

void call_back(Self self, const run_now& what) {
  auto& [parts, instance] = self->state;
  if (!instance->door->calls_back(what.due->id()))
    return; // cancelled, or closed
  auto work = parts.time->work.begin();
  const auto called = call(self, parts.time->now(), work, what.action);
  parts.time->due_times.remove(what.due->id());
  if (!called.well())
    instance->component->mailbox->leave(self);
  judge(self, called);
}

} // namespace

component_host_actor::behavior_type component_host(
    component_host_actor::stateful_pointer<component_host_state> self,
    HostParts parts, std::shared_ptr<Instance> instance) {
  self->state.parts = std::move(parts);
  self->state.instance = std::move(instance);
  return {
      [=](const start_component&) { start(self); },
      [=](const work_waits&) { work(self); },
      [=](const run_after& what) { put_off(self, what); },
      [=](const run_now& what) { call_back(self, what); },
      [=](const stop_component&) { stop(self); },
  };
}

} // namespace parlour::actors
