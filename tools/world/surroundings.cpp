#include "tools/world/surroundings.hpp"

#include <algorithm>

#include "runtime/message/replies.hpp"
#include "script/dialogue/frame/frame_evaluator.hpp"

namespace parlour::tools {

namespace input = dialogue::input;

namespace {

// More steps or timers than this without rest count as an endless loop.
constexpr std::size_t endless = 20'000;

// Removes and returns the first entry of a queue.
template <class Queue>
auto pop(Queue& queue) {
  auto first = std::move(queue.front());
  queue.pop_front();
  return first;
}

} // namespace

Surroundings::Surroundings(std::shared_ptr<const script::Program> its_program)
    : program(std::move(its_program)),
      now(parse_timestamp("2026-11-21 09:00").value()) {}

// The conversation goes first: it refers to all the rest.
Surroundings::~Surroundings() {
  conversation.reset();
}

// -- running ------------------------------------------------------------------

void Surroundings::take(dialogue::SessionInput input) {
  dialogue::take(*conversation, std::move(input), now);
}

bool Surroundings::run() {
  for (std::size_t moves = 0; move(); ++moves, ++steps)
    if (moves > endless)
      return false;
  return true;
}

// Does one thing that happens by itself; false if there is none. Frames and
// outputs come before the engine's own work, and that before answers from
// outside.
bool Surroundings::move() {
  before_move();
  if (conversation->ended())
    return false;
  if (applied_)
    take(input::FrameApplied{*std::exchange(applied_, {})});
  else if (!hold_outputs && !playing.empty())
    take(input::OutputFinished{pop(playing), true});
  else if (conversation->has_work())
    take(input::Stepped());
  else
    return answer_request();
  return true;
}

bool Surroundings::answer_request() {
  if (!hold_queries && !queries.empty()) {
    const auto request = pop(queries);
    take(input::QueryAnswered{request.id, database(request)});
  } else if (files && !wanted_files.empty()) {
    const auto [id, request] = pop(wanted_files);
    take(input::FileAnswered{id, files(request)});
  } else if (changer && !changes.empty()) {
    const auto request = pop(changes);
    take(input::ComponentAnswered{request.id, changer(request)});
  } else if (network && !opening.empty()) {
    const auto request = pop(opening);
    take(input::SocketOpened{request.id, network(request)});
  } else {
    return false;
  }
  return true;
}

bool Surroundings::advance(Milliseconds time) {
  const auto end = now + time.count();
  if (!run())
    return false;
  for (std::size_t rings = 0; !conversation->ended(); ++rings) {
    const auto next = std::ranges::min_element(
        timers_, {}, [](const auto& timer) { return timer.second; });
    if (next == timers_.end() || next->second > end)
      break;
    if (rings > endless)
      return false;
    const auto id = next->first;
    // A timer that was due earlier does not move the clock back.
    now = std::max(now, next->second);
    timers_.erase(next);
    take(input::TimerFired{id});
    if (!run())
      return false;
  }
  now = end;
  return true;
}

// -- Port ---------------------------------------------------------------------

std::vector<Message> Surroundings::post(Message message) {
  return answers ? answers(message) : std::vector<Message>{};
}

void Surroundings::subscribe(const std::vector<Subscription>& all) {
  subscriptions = all;
}

bool Surroundings::reachable(const std::string& module) const {
  return std::ranges::any_of(components, [&](const auto& component) {
    return is_source(module, component.first);
  });
}

bool Surroundings::is_source(const std::string& module,
                             const std::string& source) const {
  if (module == source)
    return true;
  const auto found = components.find(source);
  return found != components.end() &&
         found->second.contains(std::string(canonical_role(module)));
}

Reply Surroundings::reply_to_request(const Message& event) const {
  std::vector<std::string> roles{event.source};
  if (const auto found = components.find(event.source);
      found != components.end())
    roles.insert(roles.end(), found->second.begin(), found->second.end());
  return find_reply(event.command, roles, own_events).value_or(Reply::answer);
}

void Surroundings::release(const dialogue::Output& output) {
  if (hears)
    hears(output);
  playing.push_back(output.id);
}

void Surroundings::start_timer(dialogue::TimerId id, Timestamp due,
                               dialogue::TimerOwner) {
  timers_[id] = due;
}

void Surroundings::cancel_timer(dialogue::TimerId id) {
  timers_.erase(id);
}

void Surroundings::query(dialogue::QueryRequest request) {
  queries.push_back(std::move(request));
}

void Surroundings::file(dialogue::QueryId id, FileRequest request) {
  wanted_files.emplace_back(id, std::move(request));
}

void Surroundings::component(dialogue::ComponentRequest request) {
  changes.push_back(std::move(request));
}

void Surroundings::open_socket(dialogue::SocketRequest request) {
  opening.push_back(std::move(request));
}

Expected<void> Surroundings::send_socket(dialogue::SocketId,
                                         const std::string&) {
  return {};
}

void Surroundings::socket_taken(dialogue::SocketId) {}

void Surroundings::close_socket(dialogue::SocketId) {}

bool Surroundings::applies_changes() const {
  return has_frame_actors;
}

// Like an actor that was spawned for this request only. move() reports the
// result.
void Surroundings::apply(
    dialogue::TopicId, std::shared_ptr<const dialogue::FrameRequest> request) {
  applied_ = dialogue::apply(
      *program, *request,
      dialogue::make_frame_evaluator(program, request->variables, request->now,
                                     request->others));
}

void Surroundings::forget() {
  timers_.clear();
  queries.clear();
  wanted_files.clear();
  changes.clear();
  opening.clear();
  subscriptions.clear();
  playing.clear();
  applied_.reset();
}

void Surroundings::unhandled(const Message& message) {
  if (inspects_all)
    inspect({InspectionKind::unhandled, message.session,
             message.source + "." + message.command, to_string(message)});
}

bool Surroundings::inspected() const {
  return inspects_all;
}

void Surroundings::inspect(Inspection inspection) {
  if (sees)
    sees(inspection);
}

void Surroundings::ended() {
  has_ended = true;
}

} // namespace parlour::tools
