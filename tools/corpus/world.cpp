#include "tools/corpus/world.hpp"

#include <algorithm>
#include <utility>

#include "runtime/base/replies.hpp"
#include "script/dialogue/frame/frame_evaluator.hpp"

namespace parlour::tools::corpus {

using dialogue::Conversation;

namespace {

constexpr const char* seat = "corpus";
constexpr const char* recogniser = "ASR";
// Moves and rings after which a world that should be quiet is called endless.
constexpr int endless = 20'000;

Expected<void> no_network() {
  return fail(ErrorKind::network, "a corpus has no network");
}

} // namespace

World::World(std::shared_ptr<const script::Program> program,
             std::shared_ptr<const PhraseEvaluator> phrases)
    : program_(std::move(program)),
      now_(parse_timestamp("2019-03-01 09:00").value()) {
  Conversation::Options options;
  options.session = seat;
  options.phrases = std::move(phrases);
  conversation_ =
      std::make_unique<Conversation>(program_, std::move(options), *this);
}

World::~World() = default;

void World::open() {
  conversation_->open(now_);
  run();
}

bool World::say(List acts) {
  Message message;
  message.source = recogniser;
  message.command = "RecognitionResult";
  message.params = {std::move(acts), 1};
  message.session = seat;
  conversation_->receive(std::move(message));
  return run();
}

// In the order in which the session's actor would hear of it.
bool World::move() {
  auto take = [](auto& queue) {
    auto first = std::move(queue.front());
    queue.pop_front();
    return first;
  };
  if (applied_)
    conversation_->frame_applied(*std::exchange(applied_, {}), now_);
  else if (!playing_.empty())
    conversation_->output_finished(take(playing_), true, now_);
  else if (conversation_->has_work())
    conversation_->step(now_);
  else if (!queries_.empty()) {
    const auto request = take(queries_);
    conversation_->query_answered(request.id, answer(request), now_);
  } else if (!files_.empty())
    conversation_->file_answered(
        take(files_), fail(ErrorKind::file, "a corpus has no files"), now_);
  else if (!changes_.empty())
    conversation_->component_answered(
        take(changes_),
        fail(ErrorKind::refused, "a corpus has no components to change"), now_);
  else if (!sockets_.empty())
    conversation_->socket_opened(take(sockets_), no_network(), now_);
  else
    return false;
  return true;
}

bool World::run() {
  for (int moves = 0; !conversation_->ended() && move(); ++moves)
    if (moves > endless)
      return false;
  return true;
}

bool World::advance(Milliseconds time) {
  const auto end = now_ + time.count();
  for (int rings = 0; !conversation_->ended(); ++rings) {
    const auto next = std::min_element(
        timers_.begin(), timers_.end(),
        [](const auto& a, const auto& b) { return a.second < b.second; });
    if (next == timers_.end() || next->second > end)
      break;
    if (rings > endless)
      return false;
    const auto id = next->first;
    now_ = std::max(now_, next->second);
    timers_.erase(next);
    conversation_->timer_fired(id, now_);
    if (!run())
      return false;
  }
  now_ = end;
  return true;
}

// Whoever looks finds one row, without anything in it.
Expected<ResultSet> World::answer(const dialogue::QueryRequest& request) const {
  if (request.kind != dialogue::QueryRequest::Kind::query)
    return ResultSet{};
  if (!request.write)
    return ResultSet{{"found"}, {1}};
  if (!writes_succeed)
    return fail(ErrorKind::database, "refused");
  return ResultSet{};
}

std::vector<Message> World::post(Message) {
  return {};
}

bool World::reachable(const std::string& module) const {
  return canonical_role(module) == canonical_role("Database");
}

bool World::is_source(const std::string& module,
                      const std::string& source) const {
  return canonical_role(module) == canonical_role(source);
}

Reply World::reply_to_request(const Message& event) const {
  return find_reply(event.command, {event.source}).value_or(Reply::answer);
}

void World::release(const dialogue::Output& output) {
  said.push_back(output);
  playing_.push_back(output.id);
}

void World::start_timer(dialogue::TimerId id, Milliseconds after) {
  timers_[id] = now_ + after.count();
}

void World::cancel_timer(dialogue::TimerId id) {
  timers_.erase(id);
}

void World::query(dialogue::QueryRequest request) {
  queries_.push_back(std::move(request));
}

void World::file(dialogue::QueryId id, FileRequest) {
  files_.push_back(id);
}

void World::component(dialogue::ComponentRequest request) {
  changes_.push_back(request.id);
}

void World::open_socket(dialogue::SocketRequest request) {
  sockets_.push_back(request.id);
}

Expected<void> World::send_socket(dialogue::SocketId, const std::string&) {
  return no_network();
}

void World::socket_taken(dialogue::SocketId) {}

void World::close_socket(dialogue::SocketId) {}

void World::apply(dialogue::TopicId topic, dialogue::FrameRequest request) {
  auto& frame = frames_[topic];
  if (request.start)
    frame = request.start;
  applied_ = dialogue::apply(
      *program_, *frame, request,
      dialogue::make_frame_evaluator(program_, request.variables, request.now));
  frame = applied_->frame;
}

void World::unhandled(const Message&) {}

void World::inspect(Inspection inspection) {
  if (inspection.kind == InspectionKind::error)
    errors.push_back(inspection.subject + ": " + inspection.detail);
}

} // namespace parlour::tools::corpus
