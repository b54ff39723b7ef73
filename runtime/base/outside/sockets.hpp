// TCP clients of scripts (language rule 11.9), as data and an interface.
// adapters/network implements it with a thread of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/defaults.hpp"
#include "runtime/base/error.hpp"

namespace parlour {

// What a script asks for when it opens a socket.
struct SocketOrder {
  std::string address; // host:port
  bool lines = true;   // a text for each line; else as it comes
  Milliseconds timeout = defaults::request_timeout; // of the opening
};

// What happened on a socket. Each event is reported once, in order.
struct SocketEvent {
  enum class Kind : std::uint8_t {
    opened,
    failed, // was not opened; `text` says why
    text,
    closed, // by the other side, or by an error; `text` says why
  };
  Kind kind = Kind::text;
  std::string text = {};
};

// Thread-safe. Everything is asynchronous: nothing here waits for the network.
class Sockets {
public:
  using Id = std::uint64_t;
  // Receives the events of one socket, one call at a time, from the adapter's
  // thread or from within open() or taken(). It must not block and must not
  // call Sockets.
  using Tell = std::function<void(SocketEvent)>;

  virtual ~Sockets() = default;

  // Starts to connect. `opened` or `failed` follows; after `failed` or `closed`
  // no event comes any more.
  virtual Id open(SocketOrder order, Tell tell) = 0;
  // Sends the text as it is. An error of kind Network if the socket is not
  // open, or if too much is still unsent because the other side does not read.
  virtual Expected<void> send(Id id, const std::string& text) = 0;
  // The receiver has processed one text. The adapter stops reading while too
  // many texts are not processed, which makes the other side wait
  // (back-pressure).
  virtual void taken(Id id) = 0;
  // Closes the socket after sending what is still unsent, as far as the other
  // side takes it in time. No event comes after this returns. An id that is not
  // open is ignored.
  virtual void close(Id id) = 0;
};

} // namespace parlour
