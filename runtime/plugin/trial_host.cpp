#include "runtime/plugin/trial_host.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace parlour {

void TrialHost::fire_event(Message event) {
  std::lock_guard lock(mutex_);
  events_.push_back(std::move(event));
  ++fired_;
  changed_.notify_all();
}

void TrialHost::send_message(Message message) {
  std::lock_guard lock(mutex_);
  sent_.push_back(std::move(message));
}

void TrialHost::ask(Message request, Milliseconds, Reaction reaction) {
  const auto sink = request.sinks.empty() ? "" : request.sinks.front();
  after(Milliseconds::zero(), [=] {
    reaction(fail(ErrorKind::offline,
                  "nobody fills the role or has the name '" + sink + "'"));
  });
  std::lock_guard lock(mutex_);
  asked_.push_back(std::move(request));
}

PluginHost::DelayId TrialHost::after(Milliseconds delay,
                                     std::function<void()> action) {
  std::lock_guard lock(mutex_);
  later_.push_back({++last_, clock_.now() + delay.count(), std::move(action)});
  changed_.notify_all();
  return last_;
}

void TrialHost::cancel(DelayId delay) {
  std::lock_guard lock(mutex_);
  std::erase_if(later_, [&](const Later& one) { return one.id == delay; });
}

void TrialHost::failed(const std::string& reason) {
  std::lock_guard lock(mutex_);
  failures_.push_back(reason);
  changed_.notify_all();
}

const Clock& TrialHost::clock() const {
  return clock_;
}

void TrialHost::log(const std::string& text) {
  std::lock_guard lock(mutex_);
  logs_.push_back(text);
}

std::shared_ptr<const UnderstandingModel> TrialHost::understanding() const {
  return nullptr;
}

std::shared_ptr<const PhraseEvaluator> TrialHost::phrases() const {
  return nullptr;
}

Expected<std::vector<std::string>>
TrialHost::column(const std::string& name) const {
  return fail(ErrorKind::database,
              "there is no column " + name + " in a trial");
}

std::string TrialHost::data_folder() const {
  return data;
}

std::string TrialHost::application_folder() const {
  return application;
}

std::vector<Message> TrialHost::take_events() {
  std::lock_guard lock(mutex_);
  return std::exchange(events_, {});
}

std::vector<Message> TrialHost::take_sent() {
  std::lock_guard lock(mutex_);
  return std::exchange(sent_, {});
}

std::vector<Message> TrialHost::take_asked() {
  std::lock_guard lock(mutex_);
  return std::exchange(asked_, {});
}

std::vector<std::string> TrialHost::take_logs() {
  std::lock_guard lock(mutex_);
  return std::exchange(logs_, {});
}

std::vector<std::string> TrialHost::take_failures() {
  std::lock_guard lock(mutex_);
  return std::exchange(failures_, {});
}

// The earliest, and of several at one time the one that was put off first.
bool TrialHost::run_next(Timestamp until) {
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

void TrialHost::advance(Milliseconds time) {
  const auto end = clock_.now() + time.count();
  while (run_next(end))
    continue;
  clock_.time = end;
}

bool TrialHost::wait(const std::function<bool()>& done, Milliseconds patience) {
  const auto until = clock_.now() + patience.count();
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (true) {
    std::unique_lock lock(mutex_);
    const auto fired = fired_;
    const auto put_off = last_;
    lock.unlock();
    if (done())
      return true;
    if (run_next(until))
      continue;
    lock.lock();
    const auto something = changed_.wait_until(
        lock, deadline, [&] { return fired_ != fired || last_ != put_off; });
    lock.unlock();
    if (!something)
      return done();
  }
}

} // namespace parlour
