#include "adapters/loop/loop.hpp"

#include <csignal>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <asio/post.hpp>

namespace parlour::adapters {

namespace {

// Threads inherit the mask of the one that starts them.
std::thread thread_without_signals(std::function<void()> work) {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  std::optional<std::thread> thread;
  try {
    thread.emplace(std::move(work));
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    throw;
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return std::move(*thread);
}

} // namespace

struct Loop::State {
  explicit State(Thrown function) : thrown(std::move(function)) {}

  // One thread runs it, which asio is told.
  asio::io_context context{1};
  // Keeps the thread running although there may be nothing to do.
  asio::executor_work_guard<asio::io_context::executor_type> stays{
      context.get_executor()};
  // Written on the loop's thread, when it is to end.
  Milliseconds linger{};
  const Thrown thrown;
  std::thread thread;

  void work() {
    run([this] { context.run(); });
    if (linger == Milliseconds::zero())
      return;
    context.restart();
    run([this] { context.run_for(linger); });
  }

  // asio passes on what a handler throws, and can be run again then.
  template <class Run>
  void run(Run run_context) {
    for (;;)
      try {
        return run_context();
      } catch (const std::exception& exception) {
        thrown(exception.what());
      } catch (...) {
        thrown("an exception of an unknown type");
      }
  }
};

Expected<std::unique_ptr<Loop>> Loop::start(Thrown thrown) {
  try {
    auto state = std::make_unique<State>(std::move(thrown));
    // asio opens its own descriptors only with the first one that is to be
    // waited for. If there are none left, that shows here and not later.
    const asio::posix::stream_descriptor first(state->context);
    auto* const working = state.get();
    state->thread = thread_without_signals([working] { working->work(); });
    return std::unique_ptr<Loop>(new Loop(std::move(state)));
  } catch (const std::system_error& error) {
    return fail(ErrorKind::limit, error.code().message());
  }
}

Loop::Loop(std::unique_ptr<State> state) : state_(std::move(state)) {}

Loop::~Loop() {
  stop();
}

void Loop::post(Action action) {
  asio::post(state_->context, std::move(action));
}

void Loop::stop(Milliseconds linger) {
  if (!state_->thread.joinable())
    return;
  post([this, linger] {
    state_->linger = linger;
    state_->stays.reset();
    state_->context.stop();
  });
  state_->thread.join();
}

asio::io_context& Loop::context() {
  return state_->context;
}

} // namespace parlour::adapters
