#include "adapters/web/visit.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::web {

namespace {

bool is_blank(std::string_view line) {
  return std::ranges::all_of(
      line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
}

} // namespace

// -- what is heard ------------------------------------------------------------

void Visit::begin_typed() {
  kind_ = Kind::typed;
  visitor_ = book_.come(*this);
  if (visitor_ == 0)
    shut_once();
}

// A blank line of a person is no turn: somebody has only pressed Enter.
void Visit::hear_line(std::string_view line) {
  ++lines_;
  if (kind_ == Kind::unknown && is_structured(line))
    kind_ = Kind::program;
  if (kind_ == Kind::program)
    return hear_message(line);
  if (kind_ == Kind::unknown)
    begin_typed();
  else if (lines_ == 1 && is_structured(line)) {
    // Nobody says this aloud: it came after the greeting.
    refuse("too-late", "a program says hello as soon as it has connected; "
                       "connect again");
    return shut_once();
  }
  const auto typed = read_typed(line);
  if (!typed)
    return refuse("not-utf8", "line " + std::to_string(lines_) + ": " +
                                  typed.error().message);
  if (visitor_ != 0 && !is_blank(*typed))
    book_.take(visitor_, {book_.next_turn(visitor_), {*typed}});
}

// After the end was announced, what still comes is not read.
void Visit::hear_message(std::string_view text) {
  kind_ = Kind::program;
  if (shut_)
    return;
  const auto heard = read_heard(text);
  if (!heard)
    return refuse("bad-message", heard.error().message);
  std::visit([this](const auto& what) { hear(what); }, *heard);
}

void Visit::hear(const Hello& hello) {
  if (std::exchange(has_said_hello_, true))
    return refuse("bad-message", "hello was said already");
  visitor_ = book_.come(*this, hello);
  if (visitor_ == 0)
    shut_once();
}

void Visit::hear(const Turn& turn) {
  if (!has_said_hello_)
    return refuse("bad-message",
                  "say hello first: {\"type\": \"hello\", \"version\": 1}");
  book_.take(visitor_, turn);
}

void Visit::hear(const Goodbye&) {
  if (visitor_ == 0)
    return shut_once();
  book_.finish(visitor_);
}

void Visit::hear(const Ping&) {
  tell(Pong());
}

void Visit::hear_end() {
  ends_ = true;
  go_on();
}

bool Visit::is_full() const {
  return kind_ == Kind::typed && visitor_ != 0 && !book_.has_room(visitor_);
}

// -- what is told -------------------------------------------------------------

// Before it is known who is there, a person is assumed: lines.
void Visit::tell(const Told& told) {
  if (shut_)
    return;
  auto text = kind_ == Kind::program ? to_json(told) : to_line(told);
  if (!text.empty())
    send(std::move(text));
}

void Visit::refuse(const char* code, std::string message) {
  tell(Refused{code, std::move(message)});
}

void Visit::turn_away(const char* code, std::string message) {
  refuse(code, std::move(message));
  shut_once();
}

void Visit::shut_once() {
  if (!std::exchange(shut_, true))
    shut();
}

// The book lets go of the visitor: nothing is asked of it any more.
void Visit::close() {
  visitor_ = 0;
  shut_once();
}

// `printf 'hello\n' | nc` closes its side at once: the answer is still told,
// and only then the session ends.
void Visit::go_on() {
  if (ends_ && !shut_ && book_.is_answered(visitor_))
    return kind_ == Kind::typed && visitor_ != 0 ? book_.finish(visitor_)
                                                 : shut_once();
  read_on();
}

// The book decides whether the session waits for its visitor.
void Visit::lost(VisitorBook::Moment now) {
  shut_ = true;
  if (const auto visitor = std::exchange(visitor_, 0))
    book_.lose(visitor, *this, now);
}

} // namespace parlour::adapters::web
