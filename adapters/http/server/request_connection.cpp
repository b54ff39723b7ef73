#include "adapters/http/server/request_connection.hpp"

#include <utility>

#include <asio/buffer.hpp>
#include <asio/error_code.hpp>
#include <asio/write.hpp>

namespace parlour::adapters::http {

RequestConnection::RequestConnection(Socket socket,
                                     std::unique_ptr<RequestParser> parser,
                                     const Answerer& answerer,
                                     Milliseconds patience, Over over)
    : socket_(std::move(socket)), timer_(socket_.get_executor()),
      parser_(std::move(parser)), answerer_(answerer), patience_(patience),
      over_(std::move(over)) {}

void RequestConnection::start() {
  be_patient();
  read();
}

void RequestConnection::close() {
  asio::error_code ignored; // it may be closed already
  socket_.close(ignored);
  timer_.cancel();
  if (const auto over = std::exchange(over_, {}))
    over();
}

void RequestConnection::be_patient() {
  timer_.expires_after(patience_);
  timer_.async_wait([self = shared_from_this()](asio::error_code error) {
    if (!error)
      self->close();
  });
}

void RequestConnection::read() {
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
void RequestConnection::take(std::string_view bytes) {
  const auto status = parser_->take(bytes);
  if (status == 0)
    read();
  else if (status == 200)
    send(answerer_.answer(parser_->request()));
  else
    send(answerer_.refuse ? answerer_.refuse(status) : Reply{status});
}

// The patience begins anew: the other side has to read the answer now.
void RequestConnection::send(const Reply& reply) {
  answer_ = bytes_of(reply);
  be_patient();
  asio::async_write(
      socket_, asio::buffer(answer_),
      [self = shared_from_this()](asio::error_code error, std::size_t) {
        asio::error_code ignored;
        self->socket_.shutdown(Socket::shutdown_send, ignored);
        if (error)
          self->close();
        else
          self->drain();
      });
}

// Closing while the sender still sends would destroy the answer on its way.
void RequestConnection::drain() {
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
