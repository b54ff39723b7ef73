#include "tools/parlour/console/printer.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <ostream>
#include <thread>
#include <utility>

namespace parlour::tools {

struct Printer::State {
  struct Line {
    bool is_out;
    std::string text;
  };

  void add(Line line);
  void write_all();
  bool write(const Line& line);
  void close_once(std::unique_lock<std::mutex>& lock);

  std::ostream* out_stream;
  std::ostream* err_stream;
  std::function<void()> closed;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Line> lines; // the first one is being written
  std::size_t bytes = 0;  // of these
  bool is_closed = false;
  bool given_up = false;
  bool finished = false;
  std::thread thread;
};

void Printer::State::add(Line line) {
  std::unique_lock lock(mutex);
  if (finished || (line.is_out && is_closed))
    return;
  if (bytes + line.text.size() > most_to_write)
    return close_once(lock);
  bytes += line.text.size();
  lines.push_back(std::move(line));
  changed.notify_all();
}

void Printer::State::write_all() {
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [&] { return finished || !lines.empty(); });
    if (lines.empty())
      return;
    const auto& line = lines.front(); // stays where it is
    lock.unlock();
    const bool written = write(line);
    lock.lock();
    bytes -= line.text.size();
    lines.pop_front();
    if (!written)
      close_once(lock);
    changed.notify_all();
  }
}

// Only a line for `out` that is not written tells anything.
bool Printer::State::write(const Line& line) {
  auto& stream = line.is_out ? *out_stream : *err_stream;
  if (stream)
    stream << line.text << '\n' << std::flush;
  return stream || !line.is_out;
}

void Printer::State::close_once(std::unique_lock<std::mutex>& lock) {
  if (std::exchange(is_closed, true) || !closed)
    return;
  lock.unlock();
  closed();
  lock.lock();
}

Printer::Printer(std::ostream& out, std::ostream& err,
                 std::function<void()> closed)
    : state_(std::make_shared<State>()) {
  state_->out_stream = &out;
  state_->err_stream = &err;
  state_->closed = std::move(closed);
  state_->thread = std::thread([state = state_] { state->write_all(); });
}

Printer::~Printer() {
  finish();
}

void Printer::out(std::string line) {
  state_->add({true, std::move(line)});
}

void Printer::err(std::string line) {
  state_->add({false, std::move(line)});
}

void Printer::wait_for_room() {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [this] {
    return state_->bytes < room_to_write || state_->given_up;
  });
}

bool Printer::finish() {
  std::unique_lock lock(state_->mutex);
  const auto written = [this] { return state_->lines.empty(); };
  state_->changed.wait(lock, [&] { return written() || state_->given_up; });
  const bool all = state_->changed.wait_for(lock, last_lines_time, written);
  state_->finished = true;
  state_->changed.notify_all();
  lock.unlock();
  if (state_->thread.joinable())
    all ? state_->thread.join() : state_->thread.detach();
  return all;
}

void Printer::give_up() {
  std::lock_guard lock(state_->mutex);
  state_->given_up = true;
  state_->changed.notify_all();
}

} // namespace parlour::tools
