#include "script/dialogue/inputs/replay_port.hpp"

#include <cstring>
#include <utility>

#include "script/dialogue/frame/frame_evaluator.hpp"

namespace parlour::dialogue {

ReplayPort::ReplayPort(std::shared_ptr<const script::Program> program)
    : program_(std::move(program)) {}

void ReplayPort::expect(PortAnswers answers) {
  asked_ = nullptr;
  noted_ = std::move(answers);
  at_ = posts_ = failures_ = 0;
  strayed_ = false;
  wishes_ = {};
}

void ReplayPort::ask(Port& port) {
  expect({});
  asked_ = &port;
}

// The hash is looked at last, as it only says that something is different,
// while letters say whether the surroundings were asked.
std::optional<std::string> ReplayPort::difference() const {
  if (asked_)
    return {};
  if (strayed_)
    return "it asks its surroundings something else than it did";
  if (at_ < noted_.letters.size())
    return "it asks its surroundings less than it did";
  if (wishes_.hash() != noted_.wishes)
    return "it says or wants something else than it did";
  return {};
}

FrameResult ReplayPort::take_frame() {
  return std::exchange(frame_, {}).value_or(FrameResult());
}

// After the first letter that does not fit, none is given any more: what
// follows could fit by chance only.
char ReplayPort::next(const char* letters) const {
  if (!strayed_ && at_ < noted_.letters.size() &&
      std::strchr(letters, noted_.letters[at_]))
    return noted_.letters[at_++];
  strayed_ = true;
  return '\0';
}

// -- what is answered at once -------------------------------------------------

// What an inline component answered at once was done by that; only other
// messages may still have to leave after a crash (on_post).
std::vector<Message> ReplayPort::post(Message message) {
  wishes_.post(message);
  if (asked_)
    return asked_->post(std::move(message));
  if (next("pP") == 'P' && posts_ < noted_.posted.size())
    return noted_.posted[posts_++];
  if (on_post)
    on_post(message);
  return {};
}

bool ReplayPort::reachable(const std::string& module) const {
  return asked_ ? asked_->reachable(module) : next("yn") == 'y';
}

bool ReplayPort::is_source(const std::string& module,
                           const std::string& source) const {
  return asked_ ? asked_->is_source(module, source) : next("yn") == 'y';
}

Reply ReplayPort::reply_to_request(const Message& event) const {
  if (asked_)
    return asked_->reply_to_request(event);
  const auto letter = next("012");
  return letter == '1'   ? Reply::answer
         : letter == '2' ? Reply::refusal
                         : Reply::none;
}

// What is sent by a socket is not sent again: the socket is lost when the
// session goes on.
Expected<void> ReplayPort::send_socket(SocketId id, const std::string& text) {
  wishes_.send_socket(id, text);
  if (asked_ || next("sf") == 's')
    return {};
  if (failures_ < noted_.failures.size())
    return tl::make_unexpected(noted_.failures[failures_++]);
  return {};
}

// -- what is answered by an input ---------------------------------------------

void ReplayPort::subscribe(const std::vector<Subscription>& all) {
  wishes_.subscribe(all);
}

void ReplayPort::release(const Output& output) {
  wishes_.release(output);
  if (on_output)
    on_output(output);
}

void ReplayPort::start_timer(TimerId id, Timestamp due, TimerOwner) {
  wishes_.start_timer(id, due);
}

void ReplayPort::cancel_timer(TimerId id) {
  wishes_.cancel_timer(id);
}

void ReplayPort::query(QueryRequest request) {
  wishes_.query(request);
}

void ReplayPort::file(QueryId id, FileRequest request) {
  wishes_.file(id, request);
}

void ReplayPort::component(ComponentRequest request) {
  wishes_.component(request);
}

void ReplayPort::open_socket(SocketRequest request) {
  wishes_.open_socket(request);
}

void ReplayPort::close_socket(SocketId id) {
  wishes_.close_socket(id);
}

// As the topic's actor does it. The next input is FrameApplied, for which
// Replay takes the result.
void ReplayPort::apply(TopicId, std::shared_ptr<const FrameRequest> request) {
  frame_ = dialogue::apply(*program_, *request,
                           make_frame_evaluator(program_, request->variables,
                                                request->now, request->others));
}

// -- watching -----------------------------------------------------------------

void ReplayPort::unhandled(const Message& message) {
  if (on_inspection)
    on_inspection({InspectionKind::unhandled, message.session,
                   message.source + "." + message.command, to_string(message)});
}

bool ReplayPort::inspected() const {
  return on_inspection != nullptr;
}

void ReplayPort::inspect(Inspection inspection) {
  if (on_inspection)
    on_inspection(inspection);
}

void ReplayPort::conceal(const std::vector<std::string>& texts) {
  if (on_secret && !texts.empty())
    on_secret(texts);
}

void ReplayPort::conceal_turn() {
  if (on_secret)
    on_secret({});
}

void ReplayPort::ended() {
  wishes_.ended();
}

} // namespace parlour::dialogue
