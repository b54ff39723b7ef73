#include "adapters/process/component_process.hpp"

#include <utility>

namespace parlour::adapters {

namespace {

using namespace std::chrono_literals;

// Bounds the queue of messages. Further ones stay in the socket, which slows
// the process down.
constexpr std::size_t max_said = 256;
// How long a process that has closed its socket may take to exit.
constexpr Milliseconds last_breath = 200ms;
// How long a process may take to read a message without an answer.
constexpr Milliseconds time_to_read = 5s;

IpcSocket::Moment in(Milliseconds time) {
  return IpcSocket::Moment::clock::now() + time;
}

} // namespace

ComponentProcess::ComponentProcess(const ProcessOrder& order, Take take,
                                   Print print)
    : take_(std::move(take)), output_(std::move(print)),
      thread_([this, order] { work(order); }) {}

// Shutting the socket down makes the process exit and the thread leave its
// loop.
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

// The whole life of the process. It is started on this thread because the
// system kills it when the thread that started it ends (PR_SET_PDEATHSIG).
void ComponentProcess::work(const ProcessOrder& order) {
  auto child = ChildProcess::spawn(order.program, order.arguments);
  if (!child)
    return finish(child.error().message);
  {
    std::lock_guard lock(mutex_);
    child_ = std::move(*child);
    // The caller has given up while the process was being started.
    if (unwanted_ || !blame_.empty())
      child_->kill();
  }
  const auto trouble = read_all();
  const auto ending = child_->bury(trouble.empty() ? last_breath : 0ms);
  // Its last words may say why it ended.
  read_output();
  output_.finish();
  finish(trouble.empty() ? "its process " + ending : trouble);
}

// Reads until the process closes its socket or ends. Returns an empty text
// then; otherwise what is wrong with what it said.
std::string ComponentProcess::read_all() {
  for (;;) {
    child_->wait();
    read_output();
    auto messages = child_->socket().receive();
    if (!messages)
      return messages.error().kind == ErrorKind::offline
                 ? ""
                 : "its process says what cannot be read: " +
                       messages.error().message;
    for (auto& message : *messages)
      if (auto taken = deliver(std::move(message)); !taken)
        return taken.error().message;
    if (messages->empty() && child_->has_ended())
      return "";
  }
}

void ComponentProcess::read_output() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  output_.add(child_->read_output(),
              std::chrono::duration_cast<Milliseconds>(now).count());
}

// Gives a message to the calling thread or, between two calls, takes it here.
// Waits while the queue is full, and while the messages of the last call are
// being taken: the order of messages is kept in every case.
Expected<void> ComponentProcess::deliver(IpcMessage message) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] {
    return unwanted_ || (calling_ ? said_.size() < max_said : !settling_);
  });
  if (unwanted_)
    return {};
  if (!calling_) {
    lock.unlock();
    return take_(*this, message);
  }
  said_.push_back(std::move(message));
  lock.unlock();
  changed_.notify_all();
  return {};
}

// Records the end and wakes a waiting call. A reason of ours comes first: "it
// did not answer in time" says more than "was killed by signal 9".
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

Expected<IpcMessage> ComponentProcess::hello(Milliseconds within) {
  return await(IpcKind::hello, in(within));
}

Expected<IpcMessage> ComponentProcess::call(const IpcMessage& message,
                                            Milliseconds within) {
  const auto deadline = in(within);
  begin_call();
  const auto sent = child_->socket().send(message, deadline);
  if (!sent && sent.error().kind == ErrorKind::limit) {
    end_call();
    return tl::make_unexpected(sent.error());
  }
  if (!sent && sent.error().kind == ErrorKind::timeout)
    end("its process did not read what it was sent");
  return await(IpcKind::done, deadline);
}

Expected<void> ComponentProcess::tell(const IpcMessage& message) {
  return child_->socket().send(message, in(time_to_read));
}

void ComponentProcess::begin_call() {
  std::lock_guard lock(mutex_);
  calling_ = true;
}

// Takes messages until one of the given kind arrives, or `refuse`, which can
// only come instead of `hello`. After an error of `take` the loop goes on until
// next() reports the end of the process.
Expected<IpcMessage> ComponentProcess::await(IpcKind kind, Moment deadline) {
  for (;;) {
    auto message = next(deadline);
    if (!message || message->kind == kind || message->kind == IpcKind::refuse) {
      end_call();
      return message;
    }
    if (auto taken = take_(*this, *message); !taken)
      end(taken.error().message);
  }
}

// The next message. Messages that arrived before the process ended come first,
// then the error. At the deadline the process is killed, and its end is waited
// for.
Expected<IpcMessage> ComponentProcess::next(Moment deadline) {
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
  auto message = std::move(said_.front());
  said_.pop_front();
  lock.unlock();
  changed_.notify_all();
  return message;
}

// Takes the messages that arrived after `done`. Until that is finished,
// deliver() holds back further ones.
void ComponentProcess::end_call() {
  std::unique_lock lock(mutex_);
  calling_ = false;
  settling_ = true;
  const auto rest = std::exchange(said_, {});
  lock.unlock();
  for (const auto& message : rest)
    if (auto taken = take_(*this, message); !taken)
      end(taken.error().message);
  lock.lock();
  settling_ = false;
  lock.unlock();
  changed_.notify_all();
}

// Kills the process. The first reason counts.
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
