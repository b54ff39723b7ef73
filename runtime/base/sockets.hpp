// TCP clients as scripts have them (language rule 11.9): the door to the
// adapter that knows the network (adapters/network). Data and an interface; the
// thread is the adapter's.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/defaults.hpp"
#include "runtime/base/error.hpp"

namespace parlour {

struct SocketOrder {
  std::string address; // host:port
  bool lines = true;   // a text for each line; else as it comes
  Milliseconds timeout = defaults::request_timeout; // of the opening
};

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

class Sockets {
public:
  using Id = std::uint64_t;
  // Called from a thread of the adapter's, or from within open() or taken();
  // one call at a time for each socket. May not block or call back.
  using Tell = std::function<void(SocketEvent)>;

  virtual ~Sockets() = default;

  // `opened` or `failed` follows; after `failed` or `closed` nothing more.
  virtual Id open(SocketOrder order, Tell tell) = 0;
  // An error of kind Network where it is not open, or the other side does not
  // take what was sent before.
  virtual Expected<void> send(Id id, const std::string& text) = 0;
  // A text was dealt with. Nothing more is read while too many are not, so that
  // the other side has to wait.
  virtual void taken(Id id) = 0;
  // What was sent still leaves, where it is taken in time. When this returns,
  // nothing more is told. Closing what is not there does nothing.
  virtual void close(Id id) = 0;
};

} // namespace parlour
