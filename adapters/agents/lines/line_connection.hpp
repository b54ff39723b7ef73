// LineConnection is a TCP connection that carries lines of messages, plain or
// under TLS, of either side. An internal header of this folder and of client/.
//
// All functions and handlers run on the context's thread. A handler holds a
// shared pointer to its connection, so a connection lives as long as an
// operation is under way.
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include <asio.hpp>
#include <asio/ssl.hpp>

#include "adapters/agents/delivery/exchange.hpp"
#include "adapters/agents/wire/text_line.hpp"

namespace parlour::adapters::agents {

// One connection, without regard to whether it is encrypted. The listener holds
// it until it is closed or lost.
class LineConnection {
public:
  // Learns what happens. It must outlive the connection, or close it first.
  class Owner {
  public:
    virtual ~Owner() = default;
    // Bytes have arrived.
    virtual void heard(ConnectionId connection) = 0;
    virtual void arrived(ConnectionId connection,
                         Read<AgentMessage> message) = 0;
    // The other side has closed the connection, or it failed.
    virtual void lost(ConnectionId connection) = 0;
  };

  virtual ~LineConnection() = default;
  // Begins to read, under TLS after the handshake.
  virtual void start() = 0;
  virtual void write(const AgentMessage& message) = 0;
  // Closes the connection after what was written has been sent, or after some
  // time. No further event is reported.
  virtual void close() = 0;
};

// The same code for both kinds of streams: a TCP socket, or TLS over one.
template <class Stream>
class LineConnectionOver
    : public LineConnection,
      public std::enable_shared_from_this<LineConnectionOver<Stream>> {
public:
  using Side = asio::ssl::stream_base::handshake_type;
  LineConnectionOver(Stream stream, ConnectionId id, Owner& owner,
                     Side side = Side::server)
      : stream_(std::move(stream)), limit_(stream_.get_executor()), id_(id),
        owner_(&owner), side_(side) {}

  void start() override {
    // Without this option small messages are delayed; nothing else depends on
    // it.
    asio::error_code ignored;
    stream_.lowest_layer().set_option(asio::ip::tcp::no_delay(true), ignored);
    // A person at a terminal sends no beats: the system notices that the
    // terminal has gone.
    stream_.lowest_layer().set_option(asio::socket_base::keep_alive(true),
                                      ignored);
    if constexpr (is_encrypted)
      stream_.async_handshake(
          side_, [self = this->shared_from_this()](asio::error_code error) {
            error ? self->fail(handshake_failed(error)) : self->begin();
          });
    else
      begin();
  }

  void write(const AgentMessage& message) override {
    // A message that cannot be written is dropped: the exchange has checked
    // those that agents get, and its own replies are short.
    if (auto line = line_of(message))
      waiting_ += *line;
    if (waiting_.size() + leaving_.size() > max_unsent) {
      // The other side does not read. The owner learns it later, outside of its
      // own call.
      waiting_.clear();
      asio::post(stream_.get_executor(), [self = this->shared_from_this()] {
        self->fail({WireErrorKind::flood, "it does not read what it is told"});
      });
    }
    flush_soon();
  }

  void close() override {
    owner_ = nullptr;
    is_closing_ = true;
    if (!is_flushing_) {
      shut();
      return;
    }
    limit_.expires_after(close_within);
    limit_.async_wait(
        [self = this->shared_from_this()](asio::error_code error) {
          if (!error)
            self->shut();
        });
  }

private:
  static constexpr std::size_t max_unsent = 8 << 20;
  static constexpr std::chrono::seconds close_within{2};
  static constexpr bool is_encrypted =
      !std::is_same_v<Stream, asio::ip::tcp::socket>;

  // Nothing may be written before the end of the handshake.
  void begin() {
    is_ready_ = true;
    flush_soon();
    read();
  }

  // One read is always under way until the connection ends.
  void read() {
    stream_.async_read_some(asio::buffer(arriving_),
                            [self = this->shared_from_this()](
                                asio::error_code error, std::size_t size) {
                              if (error)
                                self->lost();
                              else
                                self->take({self->arriving_.data(), size});
                            });
  }

  void take(std::string_view bytes) {
    if (owner_)
      owner_->heard(id_);
    reader_.add(bytes);
    // The owner may close the connection at any message.
    while (owner_) {
      auto message = reader_.next();
      if (!message) {
        read();
        return;
      }
      owner_->arrived(id_, std::move(*message));
    }
  }

  // Flushing in a later turn combines what is written in this one.
  void flush_soon() {
    if (is_flushing_ || !is_ready_ || waiting_.empty())
      return;
    is_flushing_ = true;
    asio::post(stream_.get_executor(),
               [self = this->shared_from_this()] { self->flush(); });
  }

  // Writes what has collected, then what has collected meanwhile. At most one
  // write is under way, as asio demands.
  void flush() {
    if (waiting_.empty()) {
      is_flushing_ = false;
      if (is_closing_)
        shut();
      return;
    }
    leaving_ = std::exchange(waiting_, {});
    asio::async_write(
        stream_, asio::buffer(leaving_),
        [self = this->shared_from_this()](asio::error_code error, std::size_t) {
          self->leaving_.clear();
          if (error) {
            self->waiting_.clear();
            self->lost();
          }
          self->flush();
        });
  }

  static WireError handshake_failed(asio::error_code error) {
    return {WireErrorKind::malformed, "no TLS: " + error.message(), true};
  }

  // A mistake that closes the connection.
  void fail(WireError error) {
    if (owner_)
      owner_->arrived(id_, tl::make_unexpected(std::move(error)));
    lost();
  }

  // Reports the loss once.
  void lost() {
    if (auto* owner = std::exchange(owner_, nullptr))
      owner->lost(id_);
    shut();
  }

  // Closing cancels the operations that are under way.
  void shut() {
    limit_.cancel();
    asio::error_code ignored; // it may be closed already
    stream_.lowest_layer().shutdown(asio::ip::tcp::socket::shutdown_send,
                                    ignored);
    stream_.lowest_layer().close(ignored);
  }

  Stream stream_;
  // Ends a close that takes too long.
  asio::steady_timer limit_;
  const ConnectionId id_;
  // Null: nothing is reported any more.
  Owner* owner_;
  const Side side_; // of the handshake
  LineReader reader_;
  std::array<char, 64 << 10> arriving_;
  // To be written, and being written.
  std::string waiting_;
  std::string leaving_;
  bool is_ready_ = false;
  bool is_flushing_ = false;
  bool is_closing_ = false;
};

} // namespace parlour::adapters::agents
