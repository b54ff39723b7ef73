#include "tools/bench/dialogue/dialogue_workload.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "script/compiler/compiler.hpp"
#include "tools/bench/support/quiet_port.hpp"

namespace parlour::tools {

namespace {

using dialogue::Act;
using dialogue::ActPointer;
using dialogue::Conversation;

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

std::vector<ActPointer> six_turns() {
  std::vector<ActPointer> turns;
  for (auto& act :
       {act_about("Facility"), act_with("Name", "swimming pool"),
        act_about("Taxi"), act_with("Destination", "airport"),
        act_with("What", "location"), act_with("Wish", "no thanks")})
    turns.push_back(std::make_shared<const Act>(act));
  return turns;
}

constexpr std::size_t back_to_the_form = 3; // after this turn, by silence

// Characters said in one conversation.
std::size_t converse(const std::shared_ptr<const script::Program>& program,
                     std::span<const ActPointer> turns, QuietPort& port) {
  Conversation conversation(program, {}, port);
  conversation.open(0);
  port.run(conversation);
  std::size_t said = 0;
  for (std::size_t turn = 0; turn < turns.size(); ++turn) {
    conversation.take_acts(turns.subspan(turn, 1), 0);
    port.run(conversation);
    if (turn == back_to_the_form)
      port.be_silent(conversation);
    said += port.said();
  }
  return said;
}

std::shared_ptr<const Message> next_event() {
  Message message;
  message.source = "Robot";
  message.command = "Next";
  return std::make_shared<const Message>(std::move(message));
}

Expected<Measured> measured(double nanoseconds, std::string result,
                            const QuietPort& port) {
  if (!port.trouble().empty())
    return fail(ErrorKind::thrown, port.trouble());
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
  QuietPort port;
  const auto turns = six_turns();
  std::size_t said = 0;
  const auto start = cpu_nanoseconds();
  for (int i = 0; i < conversations; ++i)
    said += converse(program_, turns, port);
  const auto spent = cpu_nanoseconds() - start;
  return measured(
      spent / conversations / 6,
      std::to_string(said / static_cast<std::size_t>(conversations)), port);
}

Expected<Measured> DialogueWorkload::events(int count) const {
  QuietPort port;
  Conversation conversation(program_, {}, port);
  conversation.open(0);
  port.run(conversation);
  const auto event = next_event();
  const auto start = cpu_nanoseconds();
  for (int i = 0; i < count; ++i) {
    conversation.receive(event);
    conversation.step(0);
  }
  const auto spent = cpu_nanoseconds() - start;
  return measured(spent / count, conversation.state(), port);
}

} // namespace parlour::tools
