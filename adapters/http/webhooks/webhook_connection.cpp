#include "adapters/http/webhooks/webhook_connection.hpp"

#include <utility>

#include <asio/buffer.hpp>
#include <asio/error_code.hpp>
#include <asio/write.hpp>

namespace parlour::adapters::http {

namespace {

// The words are for people who look at the traffic; programs read the number.
std::string_view words_for(int status) {
  switch (status) {
  case 204:
    return "No Content";
  case 400:
    return "Bad Request";
  case 401:
    return "Unauthorized";
  case 404:
    return "Not Found";
  case 405:
    return "Method Not Allowed";
  case 413:
    return "Content Too Large";
  case 422:
    return "Unprocessable Content";
  case 429:
    return "Too Many Requests";
  case 431:
    return "Request Header Fields Too Large";
  default:
    return "Status";
  }
}

} // namespace

WebhookConnection::WebhookConnection(asio::ip::tcp::socket socket,
                                     std::unique_ptr<RequestParser> parser,
                                     Judge judge, Over over)
    : socket_(std::move(socket)), patience_(socket_.get_executor()),
      parser_(std::move(parser)), judge_(std::move(judge)),
      over_(std::move(over)) {}

// One time limit for all of it: reading, the answer, and the sender's closing.
void WebhookConnection::start(Milliseconds patience) {
  patience_.expires_after(patience);
  patience_.async_wait([self = shared_from_this()](asio::error_code error) {
    if (!error)
      self->close();
  });
  read();
}

void WebhookConnection::close() {
  asio::error_code ignored; // it may be closed already
  socket_.close(ignored);
  patience_.cancel();
  if (const auto over = std::exchange(over_, {}))
    over();
}

void WebhookConnection::read() {
  socket_.async_read_some(
      asio::buffer(buffer_),
      [self = shared_from_this()](asio::error_code error, std::size_t size) {
        if (error)
          self->close();
        else
          self->take({self->buffer_.data(), size});
      });
}

// The parser says 0 for "more is needed", else the status to answer with.
void WebhookConnection::take(std::string_view bytes) {
  const auto status = parser_->take(bytes);
  if (status == 0)
    read();
  else
    answer(status == 200 ? judge_(parser_->request()) : status);
}

void WebhookConnection::answer(int status) {
  answer_ = "HTTP/1.1 " + std::to_string(status) + ' ' +
            std::string(words_for(status)) +
            (status == 405 ? "\r\nAllow: POST" : "") +
            (status == 429 ? "\r\nRetry-After: 1" : "") +
            (status == 204 ? "" : "\r\nContent-Length: 0") +
            "\r\nConnection: close\r\n\r\n";
  asio::async_write(
      socket_, asio::buffer(answer_),
      [self = shared_from_this()](asio::error_code error, std::size_t) {
        asio::error_code ignored;
        self->socket_.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
        if (error)
          self->close();
        else
          self->drain();
      });
}

// Closing while the sender still sends would destroy the answer on its way.
void WebhookConnection::drain() {
  socket_.async_read_some(
      asio::buffer(buffer_),
      [self = shared_from_this()](asio::error_code error, std::size_t) {
        if (error)
          self->close();
        else
          self->drain();
      });
}

} // namespace parlour::adapters::http
