// The watching thread reads a signalfd. Three descriptors wake it: a signal,
// the request to stop, and raise_closed().
#include "tools/parlour/console/signal_watch.hpp"

#include <cerrno>
#include <cstdint>
#include <initializer_list>
#include <system_error>
#include <utility>

#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 &&
         action.sa_handler == SIG_IGN;
}

// The given signals without those that are ignored (nohup, background).
sigset_t signals(std::initializer_list<int> given) {
  sigset_t set;
  sigemptyset(&set);
  for (const auto signal : given)
    if (!is_ignored(signal))
      sigaddset(&set, signal);
  return set;
}

// Throws for a descriptor that the system refused.
int made(int descriptor) {
  if (descriptor < 0)
    throw std::system_error(errno, std::generic_category());
  return descriptor;
}

} // namespace

// Threads inherit the mask, so threads started later block the signals, too.
SignalWatch::SignalWatch() {
  const auto set = signals({SIGINT, SIGTERM, SIGHUP});
  pthread_sigmask(SIG_BLOCK, &set, &before_);
  signal(SIGPIPE, SIG_IGN);
  signals_ = made(signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK));
  wake_ = made(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  stop_ = made(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  thread_ = std::thread([this] { watch(); });
}

SignalWatch::~SignalWatch() {
  eventfd_write(stop_, 1);
  thread_.join();
  for (const auto descriptor : {signals_, wake_, stop_})
    close(descriptor);
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

// The action runs under the lock, here and in act(), so that nobody can remove
// it while it runs.
void SignalWatch::on_interrupt(std::function<void()> action) {
  std::lock_guard lock(mutex_);
  action_ = std::move(action);
  if (action_ && (interrupted() || closed_))
    action_();
}

int SignalWatch::status() const {
  return signal_ == SIGINT ? exit_code::interrupted : exit_code::success;
}

void SignalWatch::raise_closed() {
  closed_ = true;
  eventfd_write(wake_, 1);
}

void SignalWatch::watch() {
  pollfd waiting[] = {
      {signals_, POLLIN, 0}, {stop_, POLLIN, 0}, {wake_, POLLIN, 0}};
  while (adapters::wait_until_ready(waiting) != adapters::Waited::failed &&
         !(waiting[1].revents & POLLIN)) {
    take_signal();
    if (interrupted() || closed_) {
      act();
      waiting[2].fd = -1; // it stays readable for ever
    }
  }
}

// Unblocks SIGINT and SIGTERM after the first signal, on this thread only: the
// kernel delivers the second one here, with the action that it had before.
// SIGHUP stays blocked, because both the terminal and its shell send one.
void SignalWatch::take_signal() {
  signalfd_siginfo signal;
  if (read(signals_, &signal, sizeof signal) != sizeof signal)
    return;
  signal_ = static_cast<int>(signal.ssi_signo);
  eventfd_write(wake_, 1);
  const auto set = signals({SIGINT, SIGTERM});
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void SignalWatch::act() {
  std::lock_guard lock(mutex_);
  if (action_)
    action_();
}

} // namespace parlour::tools
