// FakeHost: conversations that begin at once and repeat what is said: "echo:
// WORDS", then the turn is done. A turn "wait" is answered by answer() only, a
// turn "end" ends the session.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "adapters/web/text_server.hpp"

namespace parlour::adapters::web::test {

// Whom the host tells: a book or a server.
template <class Teller>
class FakeHost : public Host {
public:
  Teller* teller = nullptr;
  bool begins = true;
  std::vector<std::string> calls;

  static std::string session_of(VisitorId visitor) {
    return "session-" + std::to_string(visitor);
  }

  void open(VisitorId visitor) override {
    calls.push_back("open " + std::to_string(visitor));
    if (begins)
      begin(visitor);
  }
  void begin(VisitorId visitor) {
    teller->began(visitor, session_of(visitor));
    say(visitor, "Hello.");
  }
  void take(VisitorId visitor, const Turn& turn) override {
    calls.push_back("take " + std::to_string(turn.number));
    const auto& words = turn.lines.front();
    if (words == "wait")
      return;
    for (const auto& line : turn.lines)
      say(visitor, "echo: " + line);
    answer(visitor, turn.number);
    if (words == "end")
      end(visitor);
  }
  void close(VisitorId visitor) override {
    calls.push_back("close " + std::to_string(visitor));
    end(visitor);
  }
  std::string clock() override {
    return "2026-11-21 09:00:00";
  }

  void say(VisitorId visitor, const std::string& text) {
    teller->said(visitor, session_of(visitor),
                 {0, ++outputs[visitor], "answer", text});
  }
  void answer(VisitorId visitor, std::uint64_t turn) {
    teller->done(visitor, session_of(visitor), turn);
  }
  void end(VisitorId visitor) {
    if constexpr (requires { teller->ended(0, ""); })
      teller->ended(visitor, session_of(visitor));
    else
      teller->ended(visitor, session_of(visitor), now);
  }

  VisitorBook::Moment now{};
  std::map<VisitorId, std::uint64_t> outputs;
};

} // namespace parlour::adapters::web::test
