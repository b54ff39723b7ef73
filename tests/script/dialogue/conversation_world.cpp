#include "tests/script/dialogue/conversation_world.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "script/compiler/compiler.hpp"
#include "script/dialogue/inputs/replay.hpp"
#include "script/dialogue/saved/renames.hpp"
#include "tests/support/paths.hpp"

namespace parlour::dialogue {

namespace {

constexpr const char* pipeline = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult><fire param="_LPARAM1"/></RecognitionResult></ASR>
  </component></messages></handler>)";

// A phrase as "[answer Facility {rows: …}]": its act, topic and data.
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
    : World(test::TemporaryFolder(), script, options) {}

// The folder is needed only to compile.
World::World(const test::TemporaryFolder& folder, const std::string& script,
             const WorldOptions& options)
    : Surroundings(compile(folder, script, options)),
      restores_(options.restores || std::getenv("PARLOUR_TEST_RESTORES")),
      takes_over_(std::getenv("PARLOUR_TEST_TAKES_OVER")) {
  components = {{"Keyboard", {"ASR"}}, {"SQLite", {"Database"}}};
  hears = [this](const Output& output) { said_.push_back(output.text); };
  sees = [this](const Inspection& inspection) { seen_.push_back(inspection); };
  inspects_all = true;
  options_.session = "s1";
  options_.seed = options.seed;
  options_.phrases = std::make_shared<Phrases>(*this);
  conversation = std::make_unique<Conversation>(program, options_, port_);
  if (options.open)
    open();
}

// Everything that a test does with its conversation can be repeated from what
// was noted (engine rule 7.2).
World::~World() {
  if (has_frame_actors && repeats)
    repeat();
}

void World::repeat() const {
  Replay replay(program, options_);
  for (std::size_t i = 0; i < notes_.size(); ++i) {
    auto input = read_input(program, notes_[i].first);
    ASSERT_TRUE(input) << input.error().message;
    const std::string kind(name_of(input->what));
    const auto same = replay.take(
        *std::move(input), read_answers(program, notes_[i].second).value());
    ASSERT_TRUE(same) << "repeated, input " << i + 1 << " (" << kind
                      << "): " << same.error().message;
  }
  EXPECT_TRUE(replay.conversation().save() == conversation->save())
      << "repeated, it knows something else in the end";
}

void World::take(SessionInput input) {
  const bool comes_by_itself = std::holds_alternative<input::Received>(input) ||
                               std::holds_alternative<input::TimerFired>(input);
  if (takes_over_ && comes_by_itself && conversation->is_at_rest(now)) {
    const auto lost = take_over(program);
    EXPECT_EQ(lost, Texts()) << "by the same program";
  }
  auto noted = to_bytes(*program, TimedInput{now, input});
  Surroundings::take(std::move(input));
  notes_.emplace_back(std::move(noted),
                      to_bytes(*program, port_.take_answers()));
}

void World::open() {
  take(input::Begun());
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
  take(received(std::move(message)));
}

void World::event(std::string source, std::string command,
                  std::vector<Value> params, Correlation correlation) {
  Message message;
  message.source = std::move(source);
  message.command = std::move(command);
  message.params = std::move(params);
  message.session = "s1";
  message.correlation = correlation;
  take(received(std::move(message)));
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

void World::before_move() {
  if (restores_ && conversation->expects_outcome())
    restore();
  else if (restores_)
    interrupt();
}

void World::interrupt() {
  forget();
  sockets.clear();
  restore();
  take(input::Resumed());
}

void World::restore() {
  const auto bytes = conversation->save();
  auto restored = Conversation::restore(program, options_, port_, bytes);
  if (!restored)
    throw std::runtime_error(restored.error().message);
  conversation = std::move(*restored);
  if (conversation->save() != bytes)
    throw std::runtime_error("what is read is not what was written");
}

Texts World::change_script(const std::string& script,
                           const WorldOptions& options) {
  const auto other = compile(test::TemporaryFolder(), script, options);
  EXPECT_TRUE(conversation->is_at_rest(now));
  auto lost = take_over(other);
  run();
  return lost;
}

void World::begin_instead(const std::string& script,
                          const WorldOptions& options) {
  program = compile(test::TemporaryFolder(), script, options);
  conversation =
      Conversation::begin_instead(*conversation, program, options_, port_);
  take(input::Begun());
  run();
}

Texts World::take_over(std::shared_ptr<const script::Program> other) {
  repeats = false; // nobody notes the other program
  auto taken = Conversation::take_over(*conversation, Renames(program, other),
                                       options_, port_, now);
  program = std::move(other);
  conversation = std::move(taken.conversation);
  return taken.lost;
}

void World::run() {
  if (!Surroundings::run())
    throw std::runtime_error("the world does not come to rest");
}

void World::advance(Milliseconds time) {
  if (!Surroundings::advance(time))
    throw std::runtime_error("timers ring without end");
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
  return Surroundings::post(std::move(message));
}

void World::answer_socket(const std::string& failure) {
  const auto request = opening.front();
  opening.pop_front();
  Expected<void> outcome;
  if (failure.empty())
    sockets[request.name] = request.id;
  else
    outcome = fail(ErrorKind::network, failure);
  take(input::SocketOpened{request.id, outcome});
  run();
}

void World::end_socket(const std::string& name, const std::string& why) {
  take(input::SocketClosed{sockets.at(name)});
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

} // namespace parlour::dialogue
