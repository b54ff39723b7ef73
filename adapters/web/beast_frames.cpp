// Visits by WebSocket.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <boost/asio/post.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket.hpp>

#include "adapters/web/beast_parts.hpp"
#include "adapters/web/bounds.hpp"
#include "adapters/web/origin.hpp"
#include "adapters/web/text_server.hpp"
#include "runtime/base/rate_limit.hpp"

namespace parlour::adapters::web {

namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;

std::string copy_of(beast::string_view text) {
  return {text.data(), text.size()};
}

// The request for the WebSocket is read first and judged; then each text frame
// is one message of PROTOCOL.md.
class FrameVisit : public SocketVisit {
public:
  FrameVisit(VisitParts& parts, Socket socket, const std::string& begun)
      : SocketVisit(parts.book), parts_(parts), stream_(std::move(socket)),
        timer_(parts.context.get_executor()), rate_(messages_per_second),
        head_(std::make_unique<Head>()) {
    net::buffer_copy(buffer_.prepare(begun.size()), net::buffer(begun));
    buffer_.commit(begun.size());
  }

  void start() {
    ErrorCode ignored;
    stream_.next_layer().set_option(tcp::no_delay(true), ignored);
    head_->parser.header_limit(max_head);
    head_->parser.body_limit(0);
    after(parts_.options.patience, [this] {
      if (!has_begun())
        turn_away("bad-message", "no hello has come");
    });
    http::async_read(stream_.next_layer(), buffer_, head_->parser,
                     [kept = self()](ErrorCode error, std::size_t) {
                       if (error)
                         kept->drop();
                       else
                         kept->judge();
                     });
  }

  void drop() override {
    if (std::exchange(is_over_, true))
      return;
    ErrorCode ignored;
    timer_.cancel();
    stream_.next_layer().close(ignored);
    lost(SteadyClock::now());
    parts_.remove(this);
  }

private:
  // Only until the request is answered, as it is large and visitors are many.
  struct Head {
    http::request_parser<http::string_body> parser;
    http::response<http::string_body> answer;
  };

  std::shared_ptr<FrameVisit> self() {
    return std::static_pointer_cast<FrameVisit>(shared_from_this());
  }

  template <class Action>
  void after(Milliseconds time, Action action) {
    timer_.expires_after(time);
    timer_.async_wait([kept = self(), action](ErrorCode error) {
      if (!error && !kept->is_over_)
        action();
    });
  }

  // -- the request ------------------------------------------------------------

  // Anything but an upgrade is told what this port is for.
  void judge() {
    const auto& request = head_->parser.get();
    if (buffer_.size() != 0) // frames may not come before the answer
      return answer(http::status::bad_request, "Wait for the answer\n");
    if (!websocket::is_upgrade(request))
      return answer(http::status::upgrade_required,
                    "This port speaks WebSocket, and lines: nc HOST PORT\n");
    const auto origin = request.find(http::field::origin);
    if (origin != request.end() &&
        !is_allowed_origin(copy_of(origin->value()), parts_.options.origins))
      return answer(http::status::forbidden,
                    "Pages of this origin may not connect; the option "
                    "--origin allows it\n");
    accept();
  }

  void answer(http::status status, const char* text) {
    auto& answer = head_->answer;
    answer.version(11);
    answer.result(status);
    answer.set(http::field::content_type, "text/plain; charset=utf-8");
    answer.set(http::field::connection, "close");
    if (status == http::status::upgrade_required)
      answer.set(http::field::upgrade, "websocket");
    answer.body() = text;
    answer.prepare_payload();
    http::async_write(
        stream_.next_layer(), answer, [kept = self()](ErrorCode, std::size_t) {
          ErrorCode ignored;
          kept->stream_.next_layer().shutdown(Socket::shutdown_send, ignored);
          kept->drop();
        });
  }

  void accept() {
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = parts_.options.patience;
    timeout.idle_timeout = parts_.options.idle;
    timeout.keep_alive_pings = true;
    stream_.set_option(timeout);
    stream_.read_message_max(max_message);
    stream_.text(true);
    stream_.async_accept(head_->parser.get(), [kept = self()](ErrorCode error) {
      if (error)
        return kept->drop();
      kept->head_.reset();
      kept->is_open_ = true;
      kept->read();
    });
  }

  // -- frames -----------------------------------------------------------------

  void read() {
    stream_.async_read(buffer_, [kept = self()](ErrorCode error, std::size_t) {
      if (error)
        kept->drop();
      else
        kept->take();
    });
  }

  // A frame that is refused does not end the visit; too many a second do.
  void take() {
    if (is_over_)
      return;
    const auto text = beast::buffers_to_string(buffer_.data());
    buffer_.consume(buffer_.size());
    if (!rate_.admit(SteadyClock::now()))
      turn_away("too-fast", "more than " + std::to_string(messages_per_second) +
                                " messages in a second");
    else if (!stream_.got_text())
      refuse("bad-message", "messages are text frames");
    else
      hear_message(text);
    read();
  }

  // Before the WebSocket is open there is nobody to hear it.
  void send(std::string text) override {
    if (is_over_ || !is_open_)
      return;
    unsent_ += text.size();
    waiting_.push_back(std::move(text));
    if (unsent_ > max_unsent)
      net::post(parts_.context, [kept = self()] { kept->drop(); });
    write();
  }

  void write() {
    if (is_sending_ || is_over_)
      return;
    if (waiting_.empty())
      return closing_ ? finish() : void();
    is_sending_ = true;
    sending_ = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
    stream_.async_write(net::buffer(sending_),
                        [kept = self()](ErrorCode error, std::size_t) {
                          kept->is_sending_ = false;
                          kept->unsent_ -= kept->sending_.size();
                          kept->sending_ = {};
                          if (error)
                            kept->drop();
                          else
                            kept->write();
                        });
  }

  void shut() override {
    closing_ = true;
    net::post(parts_.context, [kept = self()] { kept->write(); });
  }

  // The read that is under way meets the end.
  // Waits for the visitor's own closing frame, but not for ever.
  void finish() {
    if (!is_open_)
      return drop();
    if (std::exchange(is_finishing_, true))
      return;
    after(parts_.options.patience, [this] { drop(); });
    stream_.async_close(websocket::close_code::normal,
                        [kept = self()](ErrorCode) { kept->drop(); });
  }

  VisitParts& parts_;
  websocket::stream<Socket> stream_;
  Timer timer_;
  RateLimit rate_;
  beast::flat_buffer buffer_;
  std::unique_ptr<Head> head_; // null: it was answered
  std::vector<std::string> waiting_;
  std::string sending_;
  std::size_t unsent_ = 0; // of both, in bytes
  bool is_open_ = false;
  bool is_sending_ = false;
  bool closing_ = false;
  bool is_finishing_ = false;
  bool is_over_ = false;
};

} // namespace

void start_frame_visit(VisitParts& parts, Socket socket, std::string begun) {
  const auto visit =
      std::make_shared<FrameVisit>(parts, std::move(socket), begun);
  parts.add(visit);
  visit->start();
}

} // namespace parlour::adapters::web
