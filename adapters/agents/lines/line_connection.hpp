// LineConnection is a TCP connection that carries lines of messages, plain or
// under TLS, of either side. An internal header of this folder and of client/.
//
// All functions and handlers run on the context's thread. A handler holds a
// shared pointer to its connection, so a connection lives as long as an
// operation is under way.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <asio.hpp>
#include <asio/ssl.hpp>

#include "adapters/agents/delivery/peer_connection.hpp"
#include "adapters/agents/wire/text_line.hpp"
#include "adapters/loop/standalone_asio.hpp"

namespace parlour::adapters::agents {

using LineSocket = StandaloneAsio::Socket;

// The same code for both kinds of streams: a TCP socket, or TLS over one.
template <class Stream>
class LineConnectionOver
    : public PeerConnection,
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
    if constexpr (is_encrypted) {
      stream_.async_handshake(
          side_, [self = this->shared_from_this()](asio::error_code error) {
            error ? self->fail(handshake_failed(error)) : self->begin();
          });
    } else {
      stream_.non_blocking(true, ignored);
      begin();
    }
  }

  void write(const AgentMessage& message) override {
    // A message that cannot be written is dropped: the exchange has checked
    // those that agents get, and its own replies are short.
    (void)append_line(waiting_, message);
    if (waiting_.size() >= block)
      flush();
    if (waiting_.size() + leaving_.size() > max_unsent) {
      // The other side does not read.
      waiting_.clear();
      lose_soon(
          WireError{WireErrorKind::flood, "it does not read what it is told"});
    }
    flush_soon();
  }

  void close() override {
    owner_ = nullptr;
    is_closing_ = true;
    flush();
    if (!is_writing_) {
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
  // What has collected is written when it is so much, so that it never takes
  // much memory.
  static constexpr std::size_t block = 64 << 10;
  // For what is read at once.
  static constexpr std::size_t least_room = 16 << 10;
  static constexpr std::chrono::seconds close_within{2};
  static constexpr bool is_encrypted = !std::is_same_v<Stream, LineSocket>;

  // Nothing may be written before the end of the handshake.
  void begin() {
    is_ready_ = true;
    flush_soon();
    read();
  }

  // One read is always under way until the connection ends.
  void read() {
    const auto room = reader_.room(least_room);
    stream_.async_read_some(asio::buffer(room.data(), room.size()),
                            [self = this->shared_from_this()](
                                asio::error_code error, std::size_t size) {
                              if (error)
                                self->lost();
                              else
                                self->take(size);
                            });
  }

  // What is written meanwhile leaves together at the end.
  void take(std::size_t size) {
    is_taking_ = true;
    if (owner_)
      owner_->heard(id_);
    reader_.added(size);
    // The owner may close the connection at any message.
    while (owner_) {
      auto message = reader_.next();
      if (!message)
        break;
      owner_->arrived(id_, std::move(*message));
    }
    is_taking_ = false;
    flush();
    if (owner_)
      read();
  }

  // Flushing in a later turn combines what is written in this one.
  void flush_soon() {
    if (waiting_.empty() || is_taking_ || is_writing_ || !is_ready_ ||
        std::exchange(is_flushing_, true))
      return;
    asio::post(stream_.get_executor(), [self = this->shared_from_this()] {
      self->is_flushing_ = false;
      self->flush();
    });
  }

  // Writes what has collected, unless the end of a write is awaited: asio
  // allows one at a time.
  void flush() {
    if (!is_ready_ || is_writing_)
      return;
    if constexpr (!is_encrypted)
      write_at_once();
    if (!waiting_.empty())
      write_rest();
  }

  // As much as the system takes without waiting, which is nearly always all.
  void write_at_once() {
    std::size_t written = 0;
    asio::error_code error;
    while (!error && written < waiting_.size())
      written += stream_.write_some(
          asio::buffer(waiting_.data() + written, waiting_.size() - written),
          error);
    waiting_.erase(0, written);
    if (error && error != asio::error::would_block) {
      waiting_.clear();
      lose_soon();
    }
  }

  void write_rest() {
    is_writing_ = true;
    std::swap(leaving_, waiting_);
    asio::async_write(
        stream_, asio::buffer(leaving_),
        [self = this->shared_from_this()](asio::error_code error, std::size_t) {
          self->wrote(error);
        });
  }

  void wrote(asio::error_code error) {
    is_writing_ = false;
    leaving_.clear();
    if (error) {
      waiting_.clear();
      lost();
    }
    flush();
    if (is_closing_ && !is_writing_)
      shut();
  }

  static WireError handshake_failed(asio::error_code error) {
    return {WireErrorKind::malformed, "no TLS: " + error.message(), true};
  }

  // A mistake that closes the connection.
  void fail(WireError error) {
    if (owner_)
      owner_->heard(id_);
    if (owner_)
      owner_->arrived(id_, tl::make_unexpected(std::move(error)));
    lost();
  }

  // The owner must not learn it in its own call. Without an error the other
  // side has gone.
  void lose_soon(std::optional<WireError> error = {}) {
    asio::post(stream_.get_executor(),
               [self = this->shared_from_this(), error = std::move(error)] {
                 error ? self->fail(*error) : self->lost();
               });
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
  // To be written, and being written.
  std::string waiting_;
  std::string leaving_;
  bool is_ready_ = false;
  bool is_taking_ = false;
  // flush() will be called soon.
  bool is_flushing_ = false;
  // A write is under way.
  bool is_writing_ = false;
  bool is_closing_ = false;
};

} // namespace parlour::adapters::agents
