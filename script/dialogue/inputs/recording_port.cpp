#include "script/dialogue/inputs/recording_port.hpp"

#include <utility>

namespace parlour::dialogue {

// The hash is begun anew as well: that of an input does not depend on those
// before it, so a difference is told at the input where it is.
PortAnswers RecordingPort::take_answers() {
  answers_.wishes = std::exchange(wishes_, {}).hash();
  return std::exchange(answers_, {});
}

// -- what is answered at once -------------------------------------------------

std::vector<Message> RecordingPort::post(Message message) {
  wishes_.post(message);
  auto answers = port_.post(std::move(message));
  answers_.letters += answers.empty() ? 'p' : 'P';
  if (!answers.empty())
    answers_.posted.push_back(answers);
  return answers;
}

bool RecordingPort::reachable(const std::string& module) const {
  const bool is = port_.reachable(module);
  answers_.letters += is ? 'y' : 'n';
  return is;
}

bool RecordingPort::is_source(const std::string& module,
                              const std::string& source) const {
  const bool is = port_.is_source(module, source);
  answers_.letters += is ? 'y' : 'n';
  return is;
}

Reply RecordingPort::reply_to_request(const Message& event) const {
  const auto reply = port_.reply_to_request(event);
  answers_.letters += static_cast<char>('0' + static_cast<char>(reply));
  return reply;
}

Expected<void> RecordingPort::send_socket(SocketId id,
                                          const std::string& text) {
  wishes_.send_socket(id, text);
  auto sent = port_.send_socket(id, text);
  answers_.letters += sent ? 's' : 'f';
  if (!sent)
    answers_.failures.push_back(sent.error());
  return sent;
}

// -- what is answered by an input ---------------------------------------------

void RecordingPort::subscribe(const std::vector<Subscription>& all) {
  wishes_.subscribe(all);
  port_.subscribe(all);
}

void RecordingPort::release(const Output& output) {
  wishes_.release(output);
  if (on_output)
    on_output(output);
  port_.release(output);
}

void RecordingPort::start_timer(TimerId id, Timestamp due, TimerOwner owner) {
  wishes_.start_timer(id, due);
  port_.start_timer(id, due, owner);
}

void RecordingPort::cancel_timer(TimerId id) {
  wishes_.cancel_timer(id);
  port_.cancel_timer(id);
}

void RecordingPort::query(QueryRequest request) {
  wishes_.query(request);
  port_.query(std::move(request));
}

void RecordingPort::file(QueryId id, FileRequest request) {
  wishes_.file(id, request);
  port_.file(id, std::move(request));
}

void RecordingPort::component(ComponentRequest request) {
  wishes_.component(request);
  port_.component(std::move(request));
}

void RecordingPort::open_socket(SocketRequest request) {
  wishes_.open_socket(request);
  port_.open_socket(std::move(request));
}

void RecordingPort::close_socket(SocketId id) {
  wishes_.close_socket(id);
  port_.close_socket(id);
}

// -- what a replay has no need of ---------------------------------------------

void RecordingPort::socket_taken(SocketId id) {
  port_.socket_taken(id);
}

bool RecordingPort::applies_changes() const {
  return port_.applies_changes();
}

void RecordingPort::apply(TopicId topic,
                          std::shared_ptr<const FrameRequest> request) {
  port_.apply(topic, std::move(request));
}

void RecordingPort::unhandled(const Message& message) {
  port_.unhandled(message);
}

bool RecordingPort::inspected() const {
  return port_.inspected();
}

void RecordingPort::inspect(Inspection inspection) {
  port_.inspect(std::move(inspection));
}

void RecordingPort::conceal(const std::vector<std::string>& texts) {
  port_.conceal(texts);
}

void RecordingPort::conceal_turn() {
  port_.conceal_turn();
}

void RecordingPort::settled(std::uint64_t received) {
  port_.settled(received);
}

void RecordingPort::ended() {
  wishes_.ended();
  port_.ended();
}

} // namespace parlour::dialogue
