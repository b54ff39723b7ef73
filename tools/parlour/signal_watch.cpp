#include "tools/parlour/signal_watch.hpp"

#include <cstdint>
#include <utility>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace parlour::tools {

namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 &&
         action.sa_handler == SIG_IGN;
}

sigset_t requests_to_end() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

} // namespace

SignalWatch::SignalWatch() {
  auto set = requests_to_end();
  if (!is_ignored(SIGHUP))   // as nohup has it
    sigaddset(&set, SIGHUP); // the terminal was closed
  pthread_sigmask(SIG_BLOCK, &set, &before_);
  signal(SIGPIPE, SIG_IGN);
  signals_ = signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
  wake_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  stop_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  thread_ = std::thread([this] { watch(); });
}

SignalWatch::~SignalWatch() {
  eventfd_write(stop_, 1);
  thread_.join();
  for (const auto descriptor : {signals_, wake_, stop_})
    close(descriptor);
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void SignalWatch::on_interrupt(std::function<void()> action) {
  std::lock_guard lock(mutex_);
  action_ = std::move(action);
  if (action_ && (interrupted_ || closed_))
    action_();
}

void SignalWatch::raise_closed() {
  closed_ = true;
  eventfd_write(wake_, 1);
}

void SignalWatch::watch() {
  pollfd waiting[] = {
      {signals_, POLLIN, 0}, {stop_, POLLIN, 0}, {wake_, POLLIN, 0}};
  auto count = nfds_t{3};
  while (poll(waiting, count, -1) >= 0 && !(waiting[1].revents & POLLIN)) {
    take_signal();
    if (interrupted_ || closed_) {
      act();
      count = 2; // the descriptor stays readable
      waiting[2].revents = 0;
    }
  }
}

// From the first one on this thread is there for the second. Not so a second
// SIGHUP: both the terminal and its shell send one.
void SignalWatch::take_signal() {
  signalfd_siginfo signal;
  if (read(signals_, &signal, sizeof signal) != sizeof signal)
    return;
  interrupted_ = true;
  eventfd_write(wake_, 1);
  const auto set = requests_to_end();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void SignalWatch::act() {
  std::lock_guard lock(mutex_);
  if (action_)
    action_();
}

} // namespace parlour::tools
