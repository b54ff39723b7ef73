// TextServer: visitors talk with conversations over TCP: by lines that a person
// types, or by JSON messages in lines or WebSocket frames (PROTOCOL.md). One
// port serves all of them: what comes first tells which it is. One thread
// serves all connections.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "adapters/web/visitor_book.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::web {

// From the command line of `parlour serve`, but for `left`.
struct ServerOptions {
  std::string address = "127.0.0.1"; // of this machine
  std::uint16_t port = 0;            // 0: any that is free
  BookOptions book = {};
  // They are the visitors 1, 2, … in this order.
  std::vector<LeftVisitor> left = {};
  // Pages of these origins may connect, such as https://kiosk.example, beside
  // those of this machine.
  std::vector<std::string> origins = {};
  // Who has sent nothing by then is a person, and is greeted.
  Milliseconds first_bytes{300};
  // To say hello, and to close.
  Milliseconds patience{10'000};
  // Who does not answer a ping is gone after at most so long.
  Milliseconds idle{60'000};
};

// It does not know the conversations: `host` is told what visitors want, and
// tells what the robot says by began(), said(), done() and ended().
class TextServer {
public:
  // Gets what() of an exception, on the server's thread.
  using Thrown = std::function<void(const std::string& what)>;

  // `host` is called on the server's thread, until the server is destroyed. The
  // error says why nothing can be heard there, or that this program was built
  // without it.
  static Expected<std::unique_ptr<TextServer>> start(ServerOptions options,
                                                     Host& host, Thrown thrown);
  virtual ~TextServer() = default;

  virtual std::string address() const = 0; // "127.0.0.1:4000"

  // From any thread; they never block. As VisitorBook says.
  virtual void began(VisitorId visitor, std::string session) = 0;
  virtual void said(VisitorId visitor, std::string session, Said what) = 0;
  virtual void done(VisitorId visitor, std::string session,
                    std::uint64_t turn) = 0;
  virtual void ended(VisitorId visitor, std::string session) = 0;

  // Nobody else is let in; those who are there may go on.
  virtual void stop_accepting() = 0;
  struct Counts {
    std::size_t connections = 0;
    std::size_t sessions = 0;
    BookCounters book = {};
  };
  // Waits for the server's thread.
  virtual Counts counts() = 0;
};

} // namespace parlour::adapters::web
