#include "tools/bench/dialogue/dialogue_workload.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "script/compiler/compiler.hpp"
#include "tools/world/surroundings.hpp"

namespace parlour::tools {

namespace {

using dialogue::Act;
using dialogue::ActPointer;
using dialogue::Conversation;

// The user asks for a topic, or (act_with) gives a value without naming a
// topic.
Act act_about(const char* topic) {
  Act act;
  act.kind = dialogue::ActKind::request;
  act.topic = topic;
  act.confidence = 0.95;
  return act;
}

Act act_with(const char* slot, const char* value) {
  Act act;
  act.confidence = 0.95;
  act.slots.push_back({slot, value, 0.95, {}, {}, false});
  return act;
}

// A form is interrupted by another topic and resumed, as turns.lua does by
// hand.
std::vector<ActPointer> six_turns() {
  std::vector<ActPointer> turns;
  for (auto& act :
       {act_about("Facility"), act_with("Name", "swimming pool"),
        act_about("Taxi"), act_with("Destination", "airport"),
        act_with("What", "location"), act_with("Wish", "no thanks")})
    turns.push_back(std::make_shared<const Act>(act));
  return turns;
}

// After this turn the user is silent, and the engine takes the unfinished topic
// up again.
constexpr std::size_t back_to_the_form = 3;
// Long enough for the unfinished topic, too short to count as no input.
constexpr Milliseconds silence{3'000};

// A world that costs as little as possible: only the dialogue engine is to be
// measured. It counts the characters that are said, with a blank between the
// outputs of a turn, and keeps the last error.
struct QuietWorld : Surroundings {
  explicit QuietWorld(std::shared_ptr<const script::Program> its_program)
      : Surroundings(std::move(its_program)) {
    has_frame_actors = false;
    hears = [this](const dialogue::Output& output) {
      said += output.text.size() + (said > 0 ? 1 : 0);
    };
    sees = [this](const Inspection& inspection) {
      if (inspection.kind == InspectionKind::error)
        trouble = inspection.detail;
    };
  }

  void begin() {
    now = 0;
    conversation =
        std::make_unique<Conversation>(program, Conversation::Options(), *this);
    conversation->open(now);
    go_on();
  }
  void go_on() {
    if (!run())
      trouble = "the conversation does not come to rest";
  }
  void be_silent() {
    if (!advance(silence))
      trouble = "the conversation does not come to rest";
  }

  std::size_t said = 0;
  std::string trouble;
};

// Returns the number of characters that were said in the conversation.
std::size_t converse(QuietWorld& world, std::span<const ActPointer> turns) {
  world.begin();
  std::size_t said = 0;
  for (std::size_t turn = 0; turn < turns.size(); ++turn) {
    world.conversation->take_acts(turns.subspan(turn, 1), world.now);
    world.go_on();
    // The topic that was interrupted is resumed after a silence.
    if (turn == back_to_the_form)
      world.be_silent();
    said += std::exchange(world.said, 0);
  }
  return said;
}

std::shared_ptr<const Message> next_event() {
  Message message;
  message.source = "Robot";
  message.command = "Next";
  return std::make_shared<const Message>(std::move(message));
}

// An error of the engine makes the measurement void.
Expected<Measured> measured(double nanoseconds, std::string result,
                            const QuietWorld& world) {
  if (!world.trouble.empty())
    return fail(ErrorKind::thrown, world.trouble);
  return Measured{nanoseconds, std::move(result)};
}

} // namespace

Expected<DialogueWorkload>
DialogueWorkload::load(const std::filesystem::path& file) {
  auto compiled = script::compile_file(file, {});
  if (!compiled.program)
    return fail(ErrorKind::compile,
                script::to_string(compiled.findings.all().front()));
  return DialogueWorkload(std::move(compiled.program));
}

Expected<Measured> DialogueWorkload::turns(int conversations) const {
  QuietWorld world(program_);
  const auto turns = six_turns();
  std::size_t said = 0;
  const auto start = cpu_nanoseconds();
  for (int i = 0; i < conversations; ++i)
    said += converse(world, turns);
  const auto spent = cpu_nanoseconds() - start;
  return measured(
      spent / conversations / 6,
      std::to_string(said / static_cast<std::size_t>(conversations)), world);
}

Expected<Measured> DialogueWorkload::events(int count) const {
  QuietWorld world(program_);
  world.begin();
  auto& conversation = *world.conversation;
  const auto event = next_event();
  const auto start = cpu_nanoseconds();
  for (int i = 0; i < count; ++i) {
    // One event and one step: the state machine has no other work.
    conversation.receive(event);
    conversation.step(0);
  }
  const auto spent = cpu_nanoseconds() - start;
  return measured(spent / count, conversation.state(), world);
}

} // namespace parlour::tools
