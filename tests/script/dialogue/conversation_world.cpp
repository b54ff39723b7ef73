#include "tests/script/dialogue/conversation_world.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "runtime/base/replies.hpp"
#include "script/compiler/compiler.hpp"
#include "script/dialogue/frame/frame_evaluator.hpp"
#include "tests/support/paths.hpp"

namespace parlour::dialogue {

namespace {

// Steps after which a world that should be quiet is called endless.
constexpr std::size_t endless = 20'000;

constexpr const char* pipeline = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult><fire param="_LPARAM1"/></RecognitionResult></ASR>
  </component></messages></handler>)";

// "[answer Facility {rows: …}]": which phrase, with what.
class Phrases : public PhraseEvaluator {
public:
  explicit Phrases(const World& world) : world_(world) {}

  Rendering render(const Value& say) const override {
    auto text = "[" + say["act"].text();
    if (!say["topic"].is_unknown())
      text += " " + say["topic"].text();
    if (!say["slot"].is_unknown())
      text += "." + say["slot"].text();
    if (say["data"])
      text += " " + to_string(say["data"]);
    Rendering rendering{text + "]"};
    if (world_.fails_to_word == say["act"].text())
      rendering.failures = {
          {ErrorKind::arithmetic, "no number", {"phrases.xml", 7}}};
    return rendering;
  }

private:
  const World& world_;
};

std::shared_ptr<const script::Program>
compile(const test::TemporaryFolder& folder, const std::string& script,
        const WorldOptions& options) {
  folder.write("settings.xml", "<settings name=\"test\" start=\"" +
                                   options.start + "\"><Plugins/>" +
                                   "<Scripts><Script>test.xml</Script>" +
                                   "</Scripts><sessions " + options.sessions +
                                   "/>" + options.settings + "</settings>");
  folder.write("test.xml", "<dialogue>" + script +
                               (options.pipeline ? pipeline : "") +
                               "</dialogue>");
  script::CompileOptions compile_options;
  compile_options.platform = test::source_path("config/platform");
  auto compiled = script::compile_application(folder.path(), compile_options);
  std::string problems;
  for (const auto& finding : compiled.findings.all())
    problems += script::to_string(finding) + "\n";
  if (!compiled.program)
    throw std::runtime_error(problems);
  return compiled.program;
}

} // namespace

Value act(const char* kind, Value topic, Map slots) {
  return Map{{"act", kind}, {"topic", std::move(topic)}, {"slots", slots}};
}

Value inform(Value topic, Map slots) {
  return act("inform", std::move(topic), std::move(slots));
}

Value slot_value(Value value, double confidence) {
  return Map{{"value", std::move(value)}, {"confidence", confidence}};
}

ResultSet rows(std::vector<std::string> columns, List cells) {
  return {std::move(columns), std::move(cells)};
}

World::World(const std::string& script, const WorldOptions& options)
    : now(parse_timestamp("2026-11-21 09:00").value()),
      components{{"Keyboard", {"ASR"}}, {"SQLite", {"Database"}}} {
  program = compile(folder_, script, options);
  Conversation::Options wanted;
  wanted.session = "s1";
  wanted.seed = options.seed;
  wanted.phrases = std::make_shared<Phrases>(*this);
  conversation = std::make_unique<Conversation>(program, wanted, *this);
  if (options.open)
    open();
}

World::~World() = default;

void World::open() {
  conversation->open(now);
  run();
}

void World::say(Value acts) {
  queue(std::move(acts));
  run();
}

void World::say(const char* generic_act) {
  say(act(generic_act));
}

void World::queue(Value acts) {
  Message message;
  message.source = "Keyboard";
  message.command = "RecognitionResult";
  message.params = {std::move(acts), 1};
  message.session = "s1";
  conversation->receive(std::move(message));
}

void World::event(std::string source, std::string command,
                  std::vector<Value> params, Correlation correlation) {
  Message message;
  message.source = std::move(source);
  message.command = std::move(command);
  message.params = std::move(params);
  message.session = "s1";
  message.correlation = correlation;
  conversation->receive(std::move(message));
  run();
}

void World::broadcast(std::string source, std::string command,
                      std::vector<Value> params) {
  const auto fits = [&](const Subscription& one) {
    return (one.command == "*" || one.command == command) &&
           (one.source == "*" || is_source(one.source, source));
  };
  if (std::ranges::any_of(subscriptions, fits))
    event(std::move(source), std::move(command), std::move(params));
}

// In the order in which the session's actor would hear of it.
bool World::move() {
  if (conversation->ended())
    return false;
  if (applied_) {
    conversation->frame_applied(*std::exchange(applied_, {}), now);
    return true;
  }
  if (!hold_outputs && !playing.empty()) {
    auto id = playing.front();
    playing.pop_front();
    conversation->output_finished(id, true, now);
    return true;
  }
  if (conversation->has_work()) {
    conversation->step(now);
    return true;
  }
  if (!hold_queries && !queries.empty()) {
    auto request = std::move(queries.front());
    queries.pop_front();
    auto outcome = database ? database(request) : ResultSet{};
    conversation->query_answered(request.id, std::move(outcome), now);
    return true;
  }
  if (files && !wanted_files_.empty()) {
    const auto [id, request] = wanted_files_.front();
    wanted_files_.pop_front();
    conversation->file_answered(id, files(request), now);
    return true;
  }
  return false;
}

void World::run() {
  for (std::size_t moves = 0; move(); ++moves, ++steps)
    if (moves > endless)
      throw std::runtime_error("the world does not come to rest");
}

void World::advance(Milliseconds time) {
  const auto end = now + time.count();
  run();
  for (std::size_t rings = 0; !conversation->ended(); ++rings) {
    auto next = std::min_element(
        timers_.begin(), timers_.end(),
        [](const auto& a, const auto& b) { return a.second < b.second; });
    if (next == timers_.end() || next->second > end)
      break;
    if (rings > endless)
      throw std::runtime_error("timers ring without end");
    const auto id = next->first;
    now = std::max(now, next->second);
    timers_.erase(next);
    conversation->timer_fired(id, now);
    run();
  }
  now = end;
}

Texts World::said() {
  return std::exchange(said_, {});
}

Texts World::posted() {
  Texts texts;
  for (; posted_ < messages.size(); ++posted_) {
    const auto& message = messages[posted_];
    auto text = message.sinks.front() + "." + message.command + "(";
    for (std::size_t i = 0; i < message.params.size(); ++i)
      text += (i > 0 ? ", " : "") + to_string(message.params[i]);
    text += ")";
    if (!message.session.empty() && message.session != "s1")
      text += " of " + message.session;
    texts.push_back(std::move(text));
  }
  return texts;
}

Texts World::seen(InspectionKind kind) const {
  Texts texts;
  for (const auto& inspection : seen_)
    if (inspection.kind == kind)
      texts.push_back(inspection.subject + ": " + inspection.detail);
  return texts;
}

std::vector<Message> World::post(Message message) {
  messages.push_back(message);
  return answers ? answers(message) : std::vector<Message>{};
}

bool World::reachable(const std::string& module) const {
  return std::any_of(
      components.begin(), components.end(),
      [&](const auto& entry) { return is_source(module, entry.first); });
}

bool World::is_source(const std::string& module,
                      const std::string& source) const {
  if (module == source)
    return true;
  auto found = components.find(source);
  return found != components.end() &&
         found->second.contains(std::string(canonical_role(module)));
}

Reply World::reply_to_request(const Message& event) const {
  std::vector<std::string> roles{event.source};
  if (const auto found = components.find(event.source);
      found != components.end())
    roles.insert(roles.end(), found->second.begin(), found->second.end());
  return find_reply(event.command, roles, own_events).value_or(Reply::answer);
}

void World::release(const Output& output) {
  said_.push_back(output.text);
  playing.push_back(output.id);
}

void World::start_timer(TimerId id, Milliseconds after) {
  timers_[id] = now + after.count();
}

void World::cancel_timer(TimerId id) {
  timers_.erase(id);
}

void World::query(QueryRequest request) {
  queries.push_back(std::move(request));
}

void World::file(QueryId id, FileRequest request) {
  wanted_files_.emplace_back(id, std::move(request));
}

void World::open_socket(SocketRequest request) {
  opening.push_back(std::move(request));
}

void World::answer_socket(const std::string& failure) {
  const auto request = opening.front();
  opening.pop_front();
  Expected<void> outcome;
  if (failure.empty())
    sockets[request.name] = request.id;
  else
    outcome = fail(ErrorKind::network, failure);
  conversation->socket_opened(request.id, outcome, now);
  run();
}

void World::end_socket(const std::string& name, const std::string& why) {
  conversation->socket_closed(sockets.at(name));
  event(name, "Closed", {why});
}

std::string World::socket(SocketId id) const {
  for (const auto& [name, known] : sockets)
    if (known == id)
      return name;
  return "?";
}

Expected<void> World::send_socket(SocketId id, const std::string& text) {
  sent.push_back(socket(id) + " " + text);
  return {};
}

void World::socket_taken(SocketId id) {
  sent.push_back(socket(id) + " taken");
}

void World::close_socket(SocketId id) {
  sent.push_back(socket(id) + " closed");
}

void World::apply(TopicId topic, FrameRequest request) {
  auto& frame = frames_[topic];
  if (request.start)
    frame = request.start;
  auto result = dialogue::apply(
      *program, *frame, request,
      make_frame_evaluator(program, request.variables, request.now));
  frame = result.frame;
  applied_ = std::move(result);
}

void World::unhandled(const Message& message) {
  inspect({InspectionKind::unhandled, message.session,
           message.source + "." + message.command, to_string(message)});
}

void World::inspect(Inspection inspection) {
  seen_.push_back(std::move(inspection));
}

void World::ended() {
  has_ended = true;
}

} // namespace parlour::dialogue
