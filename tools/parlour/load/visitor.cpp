#include "tools/parlour/load/visitor.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "tools/parlour/console/finding_text.hpp"
#include "tools/parlour/conversation_test/expectation.hpp"
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

using nlohmann::json;

std::string text_of(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>()
                                                     : std::string();
}

std::uint64_t number_of(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number_unsigned()
             ? found->get<std::uint64_t>()
             : 0;
}

std::string without_ends(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t");
  const auto end = text.find_last_not_of(" \t");
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, end - begin + 1);
}

} // namespace

Visitor::Visitor(VisitorParts& parts, const Played& conversation, Moment due,
                 std::function<void()> over)
    : parts_(parts), conversation_(conversation), over_(std::move(over)),
      due_(due), last_(due) {
  connect();
}

void Visitor::connect() {
  has_ended_ = false;
  number_ = 0;
  link_ = parts_.clients.connect(parts_.address, parts_.port, parts_.by, *this);
}

// -- what the server says -----------------------------------------------------

void Visitor::opened() {
  link_->send(R"({"type": "hello", "version": 1})");
}

void Visitor::heard(const std::string& message) {
  if (is_over_)
    return;
  last_ = std::chrono::steady_clock::now();
  const auto told = json::parse(message, nullptr, false);
  const auto type = told.is_object() ? text_of(told, "type") : std::string();
  if (is_leaving_) {
    if (type == "end")
      leave();
  } else if (type == "say")
    said(without_ends(as_one_line(text_of(told, "text"))));
  else if (type == "done")
    done(number_of(told, "turn"));
  else if (type == "welcome")
    welcome(number_of(told, "process"));
  else if (type == "end")
    ended();
  else
    fail("the server says " + message);
}

void Visitor::closed(const std::string& why) {
  if (is_over_)
    return;
  if (is_leaving_)
    leave();
  else if (!has_ended_)
    fail("the connection is over: " + why);
}

void Visitor::welcome(std::uint64_t process) {
  if (at_ == 0)
    parts_.figures.opened(last_ - due_);
  if (parts_.server == 0) {
    parts_.server = process;
    parts_.memory_before = memory_of(process);
  }
  go_on();
}

// An `R~` line is about as many outputs as its pattern matches, a line each
// (docs/test.md). What comes belongs to the next line, if that is what it says;
// else to the pattern before; else the next pattern may want more.
void Visitor::said(const std::string& text) {
  const auto& answers = turn().answers;
  waiting_.push_back(text);
  if (heard_ < answers.size() &&
      is_as_expected(*answers[heard_], as_lines(waiting_))) {
    ++heard_;
    taken_ = std::exchange(waiting_, {});
    return go_on();
  }
  if (waiting_.size() == 1 && belongs_to_last(text)) {
    taken_.push_back(std::exchange(waiting_, {}).front());
    return;
  }
  const auto* expected = heard_ < answers.size() ? answers[heard_] : nullptr;
  if (!expected || expected->kind != StepKind::robot_pattern)
    is_wrong(expected, text);
}

bool Visitor::belongs_to_last(const std::string& text) const {
  const auto& answers = turn().answers;
  if (heard_ == 0 || answers[heard_ - 1]->kind != StepKind::robot_pattern)
    return false;
  auto more = taken_;
  more.push_back(text);
  return is_as_expected(*answers[heard_ - 1], as_lines(more));
}

void Visitor::done(std::uint64_t turn) {
  if (turn != number_)
    return fail("turn " + std::to_string(turn) + " is said to be done");
  is_done_ = true;
  parts_.figures.answered(last_ - due_);
  go_on();
}

// Whoever goes on after that is another visitor. A turn that was on its way to
// the session is said again then.
void Visitor::ended() {
  has_ended_ = true;
  if (!is_done_ && heard_ == 0) {
    is_done_ = true;
    heard_ = conversation_.turns[--at_].answers.size();
  }
  go_on();
}

// -- what it does -------------------------------------------------------------

void Visitor::go_on() {
  if (!is_done_ || heard_ < turn().answers.size())
    return;
  if (parts_.idle) {
    is_idle_ = true;
    return;
  }
  if (at_ + 1 == conversation_.turns.size())
    return finish();
  if (has_ended_)
    return connect(); // the greeting belongs to the next turn
  say();
}

void Visitor::say() {
  ++at_;
  heard_ = 0;
  taken_.clear();
  waiting_.clear();
  is_done_ = false;
  due_ = std::chrono::steady_clock::now();
  link_->send(
      json{{"type", "turn"}, {"turn", ++number_}, {"say", turn().lines}}.dump(
          -1, ' ', false, json::error_handler_t::replace));
}

void Visitor::look(Moment now) {
  if (is_over_ || is_idle_ || now - last_ < parts_.patience)
    return;
  if (is_leaving_)
    leave();
  else if (is_done_ && heard_ < turn().answers.size())
    is_wrong(turn().answers[heard_],
             waiting_.empty() ? "nothing" : waiting_.front());
  else
    fail("the server does not answer");
}

void Visitor::is_wrong(const Step* expected, const std::string& found) {
  const auto& lines = turn().lines;
  parts_.figures.wrong(
      conversation_.conversation->file +
      (expected ? ":" + std::to_string(expected->line) + ": expected " +
                      expected->written
                : ", after U: " + (lines.empty() ? "" : lines.back()) +
                      ": expected nothing") +
      ", found R: " + found);
  leave();
}

void Visitor::fail(const std::string& error) {
  parts_.figures.failed(conversation_.conversation->file + ": " + error);
  leave();
}

// A place that nobody has left stays taken for a time.
void Visitor::finish() {
  parts_.figures.finished();
  if (has_ended_)
    return leave();
  is_leaving_ = true;
  link_->send(R"({"type": "end"})");
}

void Visitor::leave() {
  is_over_ = true;
  over_();
}

} // namespace parlour::tools
