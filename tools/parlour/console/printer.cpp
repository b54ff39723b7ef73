// The queue of Printer and the thread that writes it.
//
// The thread owns a share of the state: if it hangs in a write, finish()
// detaches it, and the state lives on.
#include "tools/parlour/console/printer.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <ostream>
#include <thread>
#include <utility>

namespace parlour::tools {

namespace {

constexpr const char* erase_line = "\r\033[K";

} // namespace

struct Printer::State {
  // A line and the stream it is for.
  struct Line {
    bool is_out;
    std::string text;
  };

  // Called by any thread.
  void add(Line line);
  // The writing thread.
  void write_all();
  bool write(const Line& line);
  void write_status(const std::string& text);
  void close_once(std::unique_lock<std::mutex>& lock);

  std::ostream* out_stream;
  std::ostream* err_stream;
  std::function<void()> closed;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Line> lines;    // the front one is being written
  std::size_t bytes = 0;     // the sum of their sizes
  std::string status;        // below all lines
  bool status_waits = false; // to be written, also when it is being written
  bool status_shown = false; // only for the writing thread
  bool is_closed = false;
  bool given_up = false;
  bool finished = false;
  // Joined or detached by finish().
  std::thread thread;
};

void Printer::State::add(Line line) {
  std::unique_lock lock(mutex);
  if (finished || (line.is_out && is_closed))
    return;
  if (bytes + line.text.size() > max_to_write)
    // Nobody can be reading any more: give the output up instead of growing.
    return close_once(lock);
  bytes += line.text.size();
  lines.push_back(std::move(line));
  changed.notify_all();
}

// Writes without the lock, so that adding never waits for a reader. The front
// line stays in the queue until it is written: `lines` is empty only when
// nothing is left to do, and references into a deque stay valid when lines are
// added.
void Printer::State::write_all() {
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock,
                 [&] { return finished || !lines.empty() || status_waits; });
    if (lines.empty() && !status_waits)
      return;
    if (lines.empty()) {
      const auto text = status;
      lock.unlock();
      write_status(text);
      lock.lock();
      status_waits = status != text;
      changed.notify_all();
      continue;
    }
    const auto& line = lines.front(); // stays where it is
    lock.unlock();
    if (status_shown)
      write_status("");
    const bool written = write(line);
    lock.lock();
    status_waits = !status.empty();
    bytes -= line.text.size();
    lines.pop_front();
    if (!written)
      close_once(lock);
    changed.notify_all();
  }
}

// Returns false only if a line for `out` could not be written: without standard
// error a conversation can go on.
bool Printer::State::write(const Line& line) {
  auto& stream = line.is_out ? *out_stream : *err_stream;
  if (stream)
    stream << line.text << '\n' << std::flush;
  return stream || !line.is_out;
}

void Printer::State::write_status(const std::string& text) {
  status_shown = !text.empty();
  if (*err_stream)
    *err_stream << erase_line << text << std::flush;
}

// Calls `closed` at most once, without the lock: it may add lines.
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

void Printer::status(std::string line) {
  std::lock_guard lock(state_->mutex);
  if (state_->finished || state_->status == line)
    return;
  state_->status = std::move(line);
  state_->status_waits = true;
  state_->changed.notify_all();
}

void Printer::wait_for_room() {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [this] {
    return state_->bytes < room_to_write || state_->given_up;
  });
}

// First wait without limit for the queue to be empty or given up, then for the
// last lines' time.
bool Printer::finish() {
  status("");
  std::unique_lock lock(state_->mutex);
  const auto written = [this] {
    return state_->lines.empty() && !state_->status_waits;
  };
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
