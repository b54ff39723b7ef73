// Everything is recorded under one lock. Actions of delays and reactions run in
// the thread of the test, never under the lock, as they call the host again.

#include "runtime/plugin/test_host.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace parlour {

// With the lock held.
void TestHost::note_change() {
  ++changes_;
  changed_.notify_all();
}

void TestHost::fire_event(Message event) {
  std::lock_guard lock(mutex_);
  events_.push_back(std::move(event));
  note_change();
}

void TestHost::send_message(Message message) {
  std::lock_guard lock(mutex_);
  sent_.push_back(std::move(message));
  note_change();
}

// There is no other component, so the reaction is a delay of zero.
void TestHost::ask(Message request, Milliseconds, Reaction reaction) {
  const auto sink = request.sinks.empty() ? "" : request.sinks.front();
  after(Milliseconds::zero(), [=] {
    reaction(fail(ErrorKind::offline,
                  "nobody fills the role or has the name '" + sink + "'"));
  });
  std::lock_guard lock(mutex_);
  asked_.push_back(std::move(request));
  note_change();
}

// Notifies, because a delay set by another thread may be what wait() needs.
PluginHost::DelayId TestHost::after(Milliseconds delay,
                                    std::function<void()> action) {
  std::lock_guard lock(mutex_);
  later_.push_back({++last_, clock_.now() + delay.count(), std::move(action)});
  note_change();
  return last_;
}

void TestHost::cancel(DelayId delay) {
  std::lock_guard lock(mutex_);
  std::erase_if(later_, [&](const Later& one) { return one.id == delay; });
}

void TestHost::failed(const std::string& reason) {
  std::lock_guard lock(mutex_);
  failures_.push_back(reason);
  note_change();
}

void TestHost::available(bool is_available) {
  std::lock_guard lock(mutex_);
  available_ = is_available;
  note_change();
}

bool TestHost::is_available() const {
  std::lock_guard lock(mutex_);
  return available_;
}

const Clock& TestHost::clock() const {
  return clock_;
}

void TestHost::log(const std::string& text) {
  std::lock_guard lock(mutex_);
  logs_.push_back(text);
  note_change();
}

std::shared_ptr<const UnderstandingModel> TestHost::understanding() const {
  return nullptr;
}

std::shared_ptr<const PhraseEvaluator> TestHost::phrases() const {
  return nullptr;
}

Expected<std::vector<std::string>>
TestHost::column(const std::string& name) const {
  return fail(ErrorKind::database,
              "there is no column " + name + " in a trial");
}

std::string TestHost::data_folder() const {
  return data;
}

std::string TestHost::application_folder() const {
  return application;
}

std::vector<Message> TestHost::take_events() {
  std::lock_guard lock(mutex_);
  return std::exchange(events_, {});
}

std::vector<Message> TestHost::take_sent() {
  std::lock_guard lock(mutex_);
  return std::exchange(sent_, {});
}

std::vector<Message> TestHost::take_asked() {
  std::lock_guard lock(mutex_);
  return std::exchange(asked_, {});
}

std::vector<std::string> TestHost::take_logs() {
  std::lock_guard lock(mutex_);
  return std::exchange(logs_, {});
}

std::vector<std::string> TestHost::take_failures() {
  std::lock_guard lock(mutex_);
  return std::exchange(failures_, {});
}

// Runs the earliest delay; of several at one time the one that was set first.
bool TestHost::run_next(Timestamp until) {
  std::unique_lock lock(mutex_);
  const auto next = std::ranges::min_element(later_, {}, &Later::due);
  if (next == later_.end() || next->due > until)
    return false;
  clock_.time = std::max(clock_.now(), next->due);
  const auto action = std::move(next->action);
  later_.erase(next);
  lock.unlock();
  action();
  return true;
}

// The clock jumps from delay to delay, so each action sees its own time.
void TestHost::advance(Milliseconds time) {
  const auto end = clock_.now() + time.count();
  while (run_next(end))
    continue;
  clock_.time = end;
}

// Two things can make `done` true: a delay, which runs here, and whatever
// another thread says, which the condition variable reports. The counter is
// read before `done` is asked, so nothing that comes in between is missed.
bool TestHost::wait(const std::function<bool()>& done, Milliseconds patience) {
  const auto until = clock_.now() + patience.count();
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (true) {
    std::unique_lock lock(mutex_);
    const auto before = changes_;
    lock.unlock();
    if (done())
      return true;
    if (run_next(until))
      continue;
    lock.lock();
    const auto something =
        changed_.wait_until(lock, deadline, [&] { return changes_ != before; });
    lock.unlock();
    if (!something)
      return done();
  }
}

} // namespace parlour
