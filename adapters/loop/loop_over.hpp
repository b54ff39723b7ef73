// LoopOver is the thread of a Loop, over the context of either library: `Asio`
// is StandaloneAsio, or what adapters/web has of Boost.Asio. All else uses
// Loop, which says what the functions do.
#pragma once

#include <csignal>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

template <class Asio>
class LoopOver {
public:
  using Context = typename Asio::Context;
  using Action = std::function<void()>;
  using Thrown = std::function<void(const std::string& what)>;

  static Expected<std::unique_ptr<LoopOver>> start(Thrown thrown) {
    std::unique_ptr<LoopOver> loop(new LoopOver(std::move(thrown)));
    if (auto begun = loop->begin(); !begun)
      return tl::make_unexpected(std::move(begun.error()));
    return loop;
  }
  LoopOver(const LoopOver&) = delete;
  LoopOver& operator=(const LoopOver&) = delete;
  ~LoopOver() {
    stop();
  }

  void post(Action action) {
    Asio::post(context_, std::move(action));
  }

  void stop(Milliseconds linger = Milliseconds::zero()) {
    if (!thread_.joinable())
      return;
    post([this, linger] {
      linger_ = linger;
      stays_.reset();
      context_.stop();
    });
    thread_.join();
  }

  Context& context() {
    return context_;
  }

private:
  explicit LoopOver(Thrown thrown) : thrown_(std::move(thrown)) {}

  // asio opens its own descriptors only with the first one that is to be waited
  // for. If there are none left, that shows here and not later.
  Expected<void> begin() {
    try {
      const typename Asio::Descriptor first(context_);
    } catch (const typename Asio::Failure& error) {
      return fail(ErrorKind::limit, error.code().message());
    }
    return start_thread();
  }

  // Threads inherit the mask of the one that starts them. Signals are for the
  // other threads, but for those of this one's own mistakes, which a sanitizer
  // tells.
  Expected<void> start_thread() {
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    for (const int mistake : {SIGBUS, SIGFPE, SIGILL, SIGSEGV})
      sigdelset(&all, mistake);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    Expected<void> started;
    try {
      thread_ = std::thread([this] { work(); });
    } catch (const std::system_error& error) {
      started = fail(ErrorKind::limit, error.code().message());
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return started;
  }

  void work() {
    run([this] { context_.run(); });
    if (linger_ == Milliseconds::zero())
      return;
    context_.restart();
    run([this] { context_.run_for(linger_); });
  }

  // asio passes on what a handler throws, and can be run again then.
  template <class Run>
  void run(Run run_context) {
    for (;;)
      try {
        run_context();
        return;
      } catch (const std::exception& exception) {
        thrown_(exception.what());
      } catch (...) {
        thrown_("an exception of an unknown type");
      }
  }

  // One thread runs it, which asio is told.
  Context context_{1};
  // Keeps the thread running although there may be nothing to do.
  typename Asio::WorkGuard stays_{context_.get_executor()};
  // Written on the loop's thread, when it is to end.
  Milliseconds linger_{};
  const Thrown thrown_;
  std::thread thread_;
};

} // namespace parlour::adapters
