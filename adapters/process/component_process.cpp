#include "adapters/process/component_process.hpp"

#include <utility>

namespace parlour::adapters {

namespace {

using namespace std::chrono_literals;

// Said and not yet carried out; more of it waits in the socket.
constexpr std::size_t most_said = 256;
// For a process that hangs up, to end by itself.
constexpr Milliseconds last_breath = 200ms;
// For one that is alive, to take an answer.
constexpr Milliseconds time_to_read = 5s;

FrameSocket::Moment in(Milliseconds time) {
  return FrameSocket::Moment::clock::now() + time;
}

} // namespace

ComponentProcess::ComponentProcess(const ProcessOrder& order, Take take,
                                   Print print)
    : take_(std::move(take)), output_(std::move(print)),
      thread_([this, order] { work(order); }) {}

ComponentProcess::~ComponentProcess() {
  {
    std::lock_guard lock(mutex_);
    unwanted_ = true;
    if (child_)
      child_->socket().shut_down();
  }
  changed_.notify_all();
  thread_.join();
}

// -- the thread of the process ------------------------------------------------

// The process is started here, because it is to die with the thread that did
// (serve_component).
void ComponentProcess::work(const ProcessOrder& order) {
  auto child = ChildProcess::spawn(order.program, order.arguments);
  if (!child)
    return finish(child.error().message);
  {
    std::lock_guard lock(mutex_);
    child_ = std::move(*child);
    if (unwanted_ || !blame_.empty())
      child_->kill();
  }
  const auto trouble = read_all();
  const auto ending = child_->bury(trouble.empty() ? last_breath : 0ms);
  read_output(); // why, perhaps
  output_.finish();
  finish(trouble.empty() ? "its process " + ending : trouble);
}

// Until nothing more comes. Empty where the process itself has seen to that,
// else what is wrong.
std::string ComponentProcess::read_all() {
  for (;;) {
    child_->wait();
    read_output();
    auto frames = child_->socket().receive();
    if (!frames)
      return frames.error().kind == ErrorKind::offline
                 ? ""
                 : "its process says what cannot be read: " +
                       frames.error().message;
    for (auto& frame : *frames)
      if (auto taken = deliver(std::move(frame)); !taken)
        return taken.error().message;
    if (frames->empty() && child_->has_ended())
      return "";
  }
}

void ComponentProcess::read_output() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  output_.add(child_->read_output(),
              std::chrono::duration_cast<Milliseconds>(now).count());
}

Expected<void> ComponentProcess::deliver(Frame frame) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] {
    return unwanted_ || (calling_ ? said_.size() < most_said : !settling_);
  });
  if (unwanted_)
    return {};
  if (!calling_) {
    lock.unlock();
    return take_(frame);
  }
  said_.push_back(std::move(frame));
  lock.unlock();
  changed_.notify_all();
  return {};
}

void ComponentProcess::finish(const std::string& reason) {
  Over tell;
  {
    std::lock_guard lock(mutex_);
    over_ = blame_.empty() ? reason : blame_;
    if (!unwanted_)
      tell = std::exchange(tell_over_, {});
  }
  changed_.notify_all();
  if (tell)
    tell(*over_);
}

// -- calls --------------------------------------------------------------------

Expected<Frame> ComponentProcess::hello(Milliseconds within) {
  return await(FrameKind::hello, in(within));
}

Expected<Frame> ComponentProcess::call(const Frame& frame,
                                       Milliseconds within) {
  const auto deadline = in(within);
  begin_call();
  const auto sent = child_->socket().send(frame, deadline);
  if (!sent && sent.error().kind == ErrorKind::limit) {
    end_call();
    return tl::make_unexpected(sent.error());
  }
  if (!sent && sent.error().kind == ErrorKind::timeout)
    end("its process did not read what it was sent");
  return await(FrameKind::done, deadline);
}

Expected<void> ComponentProcess::tell(const Frame& frame) {
  return child_->socket().send(frame, in(time_to_read));
}

void ComponentProcess::begin_call() {
  std::lock_guard lock(mutex_);
  calling_ = true;
}

// The frame of that kind; carries out those before it.
Expected<Frame> ComponentProcess::await(FrameKind kind, Moment deadline) {
  for (;;) {
    auto frame = next(deadline);
    if (!frame || frame->kind == kind || frame->kind == FrameKind::refuse) {
      end_call();
      return frame;
    }
    if (auto taken = take_(*frame); !taken)
      end(taken.error().message);
  }
}

// What was said before it was over comes before the error.
Expected<Frame> ComponentProcess::next(Moment deadline) {
  auto there = [this] { return !said_.empty() || over_; };
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, deadline, there);
  if (!over_ && Moment::clock::now() >= deadline) {
    lock.unlock();
    end("its process did not answer in time");
    lock.lock();
    changed_.wait(lock, there);
  }
  if (said_.empty())
    return fail(ErrorKind::offline, *over_);
  auto frame = std::move(said_.front());
  said_.pop_front();
  lock.unlock();
  changed_.notify_all();
  return frame;
}

void ComponentProcess::end_call() {
  std::unique_lock lock(mutex_);
  calling_ = false;
  settling_ = true;
  const auto rest = std::exchange(said_, {});
  lock.unlock();
  for (const auto& frame : rest)
    if (auto taken = take_(frame); !taken)
      end(taken.error().message);
  lock.lock();
  settling_ = false;
  lock.unlock();
  changed_.notify_all();
}

void ComponentProcess::end(const std::string& reason) {
  std::lock_guard lock(mutex_);
  if (blame_.empty())
    blame_ = reason;
  if (child_)
    child_->kill();
}

void ComponentProcess::when_over(Over over) {
  std::unique_lock lock(mutex_);
  tell_over_ = std::move(over);
  if (!over_ || !tell_over_)
    return;
  const auto tell = std::exchange(tell_over_, {});
  lock.unlock();
  tell(*over_);
}

} // namespace parlour::adapters
