// Visits by lines.
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <netinet/tcp.h>

#include "adapters/web/beast_parts.hpp"
#include "adapters/web/bounds.hpp"
#include "adapters/web/text_server.hpp"
#include "runtime/base/rate_limit.hpp"

namespace parlour::adapters::web {

namespace {

constexpr std::string_view request_begin = "GET ";
// Who sends more of one line than this is no person.
constexpr std::size_t max_skipped = 1 << 20;
// How long the other side may take to read its last words.
constexpr Milliseconds time_to_close{1'000};
// Of the system, in seconds, and how often.
// A connection whose other side has vanished is noticed after a minute: 30 s
// and three probes of 10 s.
constexpr int silent_before_probe = 30;
constexpr int between_probes = 10;
constexpr int probes = 3;

// A connection begins here whatever it speaks, as only its first bytes tell. Of
// a person no more lines are read than are answered; a program counts its turns
// itself.
//
// How a connection ends, each way by drop() at last:
//
//   the visitor goes      end_of_input(), the answers, shut(), finish()
//   the session is over   close(), shut(), finish(): 1 s to read the rest
//   it does not read      more than max_unsent waits: drop()
//   an error              drop()
class LineVisit : public SocketVisit {
public:
  LineVisit(VisitParts& parts, Socket socket)
      : SocketVisit(parts.book), parts_(parts), socket_(std::move(socket)),
        timer_(parts.context.get_executor()), rate_(messages_per_second) {}

  // The timer's end decides for a person, if nothing has come by then.
  void start() {
    ErrorCode ignored;
    socket_.non_blocking(true, ignored);
    after(parts_.options.first_bytes, [this] {
      if (has_begun() || !in_.empty())
        return expect_line();
      keep_alive(socket_);
      begin_typed();
    });
    read();
  }

  void drop() override {
    if (std::exchange(is_over_, true))
      return;
    ErrorCode ignored;
    timer_.cancel();
    socket_.close(ignored);
    lost(SteadyClock::now());
    parts_.remove(this);
  }

private:
  std::shared_ptr<LineVisit> self() {
    return std::static_pointer_cast<LineVisit>(shared_from_this());
  }

  template <class Action>
  void after(Milliseconds time, Action action) {
    timer_.expires_after(time);
    timer_.async_wait([kept = self(), action](ErrorCode error) {
      if (!error && !kept->is_over_)
        action();
    });
  }

  // Half a line has come and no more.
  void expect_line() {
    if (!has_begun())
      after(parts_.options.patience, [this] {
        if (!has_begun())
          turn_away("bad-message", "no whole line has come");
      });
  }

  // -- reading ----------------------------------------------------------------

  // Waits without a buffer: most connections are silent most of the time.
  void read() {
    if (reading_ || has_ended_ || is_over_ || is_full())
      return;
    reading_ = true;
    socket_.async_wait(Socket::wait_read, [kept = self()](ErrorCode error) {
      kept->reading_ = false;
      if (error)
        kept->drop();
      else
        kept->read_some();
    });
  }

  // The buffer is shared by all connections of the thread: what was read is
  // taken before anything else is.
  void read_some() {
    static thread_local std::array<char, 16'384> bytes;
    ErrorCode error;
    const auto size = socket_.read_some(net::buffer(bytes), error);
    if (error == net::error::would_block)
      return read();
    if (error == net::error::eof)
      return end_of_input();
    if (error)
      return drop();
    take({bytes.data(), size});
  }

  // While what has come may still become "GET ", nothing is decided.
  void take(std::string_view bytes) {
    in_ += bytes;
    if (!has_begun() && in_.starts_with(request_begin))
      return become_frames();
    if (!has_begun() && request_begin.starts_with(in_))
      return read();
    take_lines();
    read();
  }

  // The socket moves to the other visit, and this one goes without having said
  // or heard anything.
  void become_frames() {
    is_over_ = true; // nothing was begun
    timer_.cancel();
    start_frame_visit(parts_, std::move(socket_), std::move(in_));
    parts_.remove(this);
  }

  // Reading stops where the visitor has no room for a turn; the rest stays in
  // `in_` until read_on().
  void take_lines() {
    std::size_t begin = 0;
    while (!is_full() && !closing_) {
      const auto end = in_.find('\n', begin);
      if (end == std::string::npos)
        break;
      take_line(std::string_view(in_).substr(begin, end - begin));
      begin = end + 1;
    }
    in_.erase(0, begin);
    if (!is_full())
      skip_what_is_too_long();
    if (in_.empty())
      in_.shrink_to_fit();
  }

  // The end of a line that was too long is no line of its own.
  void take_line(std::string_view line) {
    if (std::exchange(skipped_, 0) != 0)
      return;
    if (!has_begun())
      keep_alive(socket_);
    if (line.size() > max_message)
      return too_long();
    if (!is_typed() && !rate_.admit(SteadyClock::now()))
      return turn_away("too-fast", "more than " +
                                       std::to_string(messages_per_second) +
                                       " lines in a second");
    hear_line(line);
  }

  void too_long() {
    refuse("too-long", "a line has at most " + std::to_string(max_message) +
                           " bytes; this one was not taken");
  }

  // Told once for each such line; its rest is thrown away as it comes.
  void skip_what_is_too_long() {
    if (in_.size() <= max_message || in_.find('\n') != std::string::npos)
      return;
    if (skipped_ == 0)
      too_long();
    skipped_ += in_.size();
    in_.clear();
    if (skipped_ > max_skipped)
      turn_away("too-long", "a line without an end");
  }

  // What is left is a line, too.
  void end_of_input() {
    has_ended_ = true;
    if (closing_)
      return drop();
    if (!in_.empty() && !is_full())
      take_line(std::exchange(in_, {}));
    if (!has_begun())
      return drop();
    after(parts_.options.patience, [this] { drop(); });
    hear_end();
  }

  void read_on() override {
    take_lines();
    if (has_ended_ && !in_.empty() && !is_full())
      take_line(std::exchange(in_, {}));
    read();
  }

  // -- writing ----------------------------------------------------------------

  // Who does not read is dropped. Not at once: the caller may be in the middle
  // of a loop over visits.
  void send(std::string text) override {
    if (is_over_)
      return;
    waiting_ += text;
    waiting_ += '\n';
    if (waiting_.size() > max_unsent)
      net::post(parts_.context, [kept = self()] { kept->drop(); });
    write();
  }

  // All that waits goes in one piece.
  void write() {
    if (!sending_.empty() || is_over_)
      return;
    if (waiting_.empty())
      return closing_ ? finish() : void();
    sending_.swap(waiting_);
    net::async_write(socket_, net::buffer(sending_),
                     [kept = self()](ErrorCode error, std::size_t) {
                       kept->sending_ = {};
                       if (error)
                         kept->drop();
                       else
                         kept->write();
                     });
  }

  // Posted, as the book may be the caller: the visit removes itself from there.
  void shut() override {
    closing_ = true;
    net::post(parts_.context, [kept = self()] { kept->write(); });
  }

  // Whoever reads gets all of it before the connection is closed.
  void finish() {
    ErrorCode ignored;
    socket_.shutdown(Socket::shutdown_send, ignored);
    if (has_ended_ || ignored)
      return drop();
    after(time_to_close, [this] { drop(); });
    in_.clear();
    read();
  }

  VisitParts& parts_;
  Socket socket_;
  Timer timer_;
  RateLimit rate_;
  std::string in_;
  std::size_t skipped_ = 0; // of a line that is too long
  std::string waiting_;
  std::string sending_;
  bool reading_ = false;
  bool has_ended_ = false; // the other side sends no more
  bool closing_ = false;
  bool is_over_ = false;
};

} // namespace

void start_line_visit(VisitParts& parts, Socket socket) {
  const auto visit = std::make_shared<LineVisit>(parts, std::move(socket));
  parts.add(visit);
  visit->start();
}

// Nothing is lost where the system cannot.
void keep_alive(Socket& socket) {
  ErrorCode ignored;
  socket.set_option(net::socket_base::keep_alive(true), ignored);
  socket.set_option(tcp::no_delay(true), ignored);
  const int handle = socket.native_handle();
  setsockopt(handle, IPPROTO_TCP, TCP_KEEPIDLE, &silent_before_probe,
             sizeof silent_before_probe);
  setsockopt(handle, IPPROTO_TCP, TCP_KEEPINTVL, &between_probes,
             sizeof between_probes);
  setsockopt(handle, IPPROTO_TCP, TCP_KEEPCNT, &probes, sizeof probes);
}

} // namespace parlour::adapters::web
