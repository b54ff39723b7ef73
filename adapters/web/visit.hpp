// Visit: what one connection says and hears, without its socket: whether it is
// a person who types lines or a program, its hello, its turns. The sockets'
// classes derive from it; the server calls all on its thread.
#pragma once

#include <string>
#include <string_view>

#include "adapters/web/visitor_book.hpp"

namespace parlour::adapters::web {

// Who it is shows in the first bytes: a line that begins with '{' is a
// program's, any other a person's; who sends nothing for a moment is a person
// who waits for a greeting (ServerOptions::first_bytes).
//
// Where what comes in goes to:
//
//   socket -> hear_line(), hear_message() -> VisitorBook -> Host
//   socket <- send(), shut() <- tell(), close() <- VisitorBook
class Visit : public Connection {
public:
  explicit Visit(VisitorBook& book) : book_(book) {}
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

  // A person is there, who is greeted.
  // Begins a session at once, without a hello.
  void begin_typed();
  // A line that a person or a program has sent. The first one decides who it
  // is, unless begin_typed() has.
  void hear_line(std::string_view line);
  // A message of a program.
  void hear_message(std::string_view text);
  // No more will come, but what was said is still answered.
  void hear_end();
  // Something that cannot be taken was sent; the visit goes on.
  // `code` is one of PROTOCOL.md.
  void refuse(const char* code, std::string message);
  // The same, and it ends.
  void turn_away(const char* code, std::string message);
  // The connection is gone. Nothing is told any more.
  void lost(VisitorBook::Moment now);

  // A person has more to say than fits: nothing more is to be read until
  // go_on() is called.
  bool is_full() const;
  bool has_begun() const {
    return kind_ != Kind::unknown;
  }
  // A person, who is read no faster than answered.
  bool is_typed() const {
    return kind_ == Kind::typed;
  }

  void tell(const Told& told) final;
  void close() final;
  void go_on() final;

protected:
  // Sends a line or message, in order.
  virtual void send(std::string text) = 0;
  // Closes when all of that is sent.
  virtual void shut() = 0;
  // is_full() may have changed.
  virtual void read_on() {}

private:
  enum class Kind : std::uint8_t {
    unknown,
    typed,   // lines of a person
    program, // JSON
  };

  void hear(const Hello& hello);
  void hear(const Turn& turn);
  void hear(const Goodbye&);
  void hear(const Ping&);
  // Later calls do nothing.
  void shut_once();

  VisitorBook& book_;
  Kind kind_ = Kind::unknown;
  VisitorId visitor_ = 0; // 0: not come yet, or refused
  std::uint64_t lines_ = 0;
  bool has_said_hello_ = false;
  bool ends_ = false; // when all is answered
  bool shut_ = false;
};

} // namespace parlour::adapters::web
