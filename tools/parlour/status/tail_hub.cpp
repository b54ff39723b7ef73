#include "tools/parlour/status/tail_hub.hpp"

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include "adapters/loop/wait_until_ready.hpp"
#include "runtime/message/typed_turn.hpp"

namespace parlour::tools {

namespace {

constexpr std::size_t at_once = 64 << 10;    // bytes
constexpr std::size_t max_sessions = 10'000; // whose turns are known

std::string told_of(std::uint64_t lost) {
  return "-- " + std::to_string(lost) + " lines lost: they were not read in " +
         "time";
}

// True where nobody reads any more: readers say nothing.
bool has_left(int socket) {
  char byte;
  const auto got = recv(socket, &byte, 1, MSG_DONTWAIT);
  return got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR);
}

} // namespace

TailHub::TailHub(RolesByComponent roles)
    : roles_(std::move(roles)), wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

TailHub::~TailHub() {
  close();
}

void TailHub::connect(Watch watch) {
  const std::lock_guard lock(mutex_);
  watch_ = std::move(watch);
}

void TailHub::see(const Inspection& seen, Timestamp now) {
  if (!is_followed_)
    return;
  const std::lock_guard lock(mutex_);
  const auto known = with_turn(seen);
  std::string line;
  for (auto& reader : readers_) {
    if (!reader.filter.takes(seen, roles_))
      continue;
    if (reader.lines.size() >= max_lines) {
      ++reader.lost;
      continue;
    }
    if (line.empty())
      line = tail_line(known, now);
    if (reader.lost > 0)
      reader.lines.push_back(told_of(std::exchange(reader.lost, 0)));
    reader.lines.push_back(line);
    if (reader.lines.size() <= 2)
      eventfd_write(wake_.get(), 1);
  }
}

// Messages are shown on their way, where nobody knows the turn.
Inspection TailHub::with_turn(const Inspection& seen) {
  auto known = seen;
  if (seen.session.empty())
    return known;
  const auto number = seen.message ? number_of_turn(*seen.message) : 0;
  if (turns_.size() >= max_sessions && !turns_.contains(seen.session))
    turns_.clear();
  auto& turn = turns_[seen.session];
  turn = std::max({turn, seen.turn, number});
  known.turn = turn;
  return known;
}

void TailHub::add(Descriptor reader, TailFilter filter) {
  const std::lock_guard lock(mutex_);
  if (ends_ || readers_.size() >= max_readers) {
    constexpr std::string_view refusal = "-- too many follow already\n";
    send(reader.get(), refusal.data(), refusal.size(),
         MSG_NOSIGNAL | MSG_DONTWAIT);
    return;
  }
  readers_.push_back({std::move(reader), std::move(filter)});
  if (watch_ && !is_followed_)
    watch_(true);
  is_followed_ = true;
  if (!thread_.joinable())
    thread_ = std::thread([this] { serve(); });
  eventfd_write(wake_.get(), 1);
}

void TailHub::close() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    watch_ = nullptr;
    eventfd_write(wake_.get(), 1);
  }
  if (thread_.joinable())
    thread_.join();
  const std::lock_guard lock(mutex_);
  for (auto& reader : readers_) { // the last words, as far as they fit
    take_lines(reader);
    send_some(reader);
  }
  readers_.clear();
}

// -- the hub's thread ---------------------------------------------------------

// Readers are added and seen by others, and removed here only: so pointers to
// them stay good without the lock.
void TailHub::serve() {
  for (;;) {
    std::vector<pollfd> waiting = {{wake_.get(), POLLIN, 0}};
    std::vector<Reader*> readers;
    {
      const std::lock_guard lock(mutex_);
      if (!drop_those_gone())
        return;
      for (auto& reader : readers_) {
        const short wanted = has_something(reader) ? POLLIN | POLLOUT : POLLIN;
        waiting.push_back({reader.socket.get(), wanted, 0});
        readers.push_back(&reader);
      }
    }
    if (adapters::wait_until_ready(waiting) == adapters::Waited::failed)
      return;
    eventfd_t ignored;
    eventfd_read(wake_.get(), &ignored);
    for (std::size_t i = 0; i < readers.size(); ++i) {
      auto& reader = *readers[i];
      const auto came = waiting[i + 1].revents;
      if ((came & ~POLLOUT) != 0)
        reader.is_gone = has_left(reader.socket.get());
      if ((came & POLLOUT) == 0 || reader.is_gone)
        continue;
      {
        const std::lock_guard lock(mutex_);
        take_lines(reader);
      }
      send_some(reader);
    }
  }
}

bool TailHub::drop_those_gone() {
  readers_.remove_if([](const Reader& reader) { return reader.is_gone; });
  if (is_followed_ && readers_.empty()) {
    turns_.clear();
    is_followed_ = false;
    if (watch_)
      watch_(false);
  }
  return !ends_;
}

bool TailHub::has_something(const Reader& reader) {
  return !reader.unsent.empty() || !reader.lines.empty() || reader.lost > 0;
}

void TailHub::take_lines(Reader& reader) {
  while (!reader.lines.empty() && reader.unsent.size() < at_once) {
    reader.unsent += reader.lines.front() + "\n";
    reader.lines.pop_front();
  }
  if (reader.lines.empty() && reader.lost > 0)
    reader.unsent += told_of(std::exchange(reader.lost, 0)) + "\n";
}

void TailHub::send_some(Reader& reader) {
  const auto sent = send(reader.socket.get(), reader.unsent.data(),
                         reader.unsent.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent >= 0)
    reader.unsent.erase(0, static_cast<std::size_t>(sent));
  else if (errno != EAGAIN && errno != EINTR)
    reader.is_gone = true;
}

} // namespace parlour::tools
