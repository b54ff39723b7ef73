// Each kind of line has a function of its own. Lines that say what happens
// drive the conversation; lines that say what must hold compare, and report
// faults.
#include "tools/corpus/player.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "script/run/phrase_evaluator.hpp"

namespace parlour::tools::corpus {

namespace {

constexpr std::array fault_names = {
#define X(name, sentence) std::string_view(#name),
    PARLOUR_CORPUS_FAULTS(X)
#undef X
};

// What the simulated user answers to a question for which the corpus has no
// answer.
constexpr const char* any_answer = "something";
// How many questions about one topic it answers.
constexpr int max_answers = 20;
// How long the user listens after a turn: long enough for an unfinished topic
// to be resumed, too short to count as no input.
constexpr Milliseconds listening{3000};

// Unknown is compared as an empty text.
std::string text_of(const Value& value) {
  return value.is_unknown() ? std::string() : value.text();
}

// An act as language understanding would give it.
Map act_of(const std::string& kind, const std::string& topic, bool elliptical) {
  return Map{{"act", kind},
             {"topic", topic.empty() ? Value() : Value(topic)},
             {"elliptical", elliptical},
             {"slots", Map()}};
}

} // namespace

std::string_view name_of(FaultKind kind) {
  return fault_names[static_cast<std::size_t>(kind)];
}

Player::Player(std::shared_ptr<const script::Program> program, Tell tell)
    : program_(std::move(program)),
      phrases_(script::make_phrase_evaluator(program_)),
      tell_(std::move(tell)) {}

void Player::play(const std::vector<Line>& lines) {
  for (const auto& line : lines)
    take(line);
  end_turn();
}

// Calls the function that has the name of the line.
void Player::take(const Line& line) {
  if (line.kind != LineKind::is)
    close_state();
  switch (line.kind) {
#define X(name, fields, sentence)                                              \
  case LineKind::name:                                                         \
    name(line);                                                                \
    return;
    PARLOUR_CORPUS_LINES(X)
#undef X
  }
}

// -- what happens -------------------------------------------------------------

// Each dialogue has a conversation and a world of its own.
void Player::dialogue(const Line& line) {
  ++counts_.dialogues;
  name_ = line.fields[0];
  turn_.clear();
  known_.clear();
  said_before_ = looked_at_ = errors_told_ = 0;
  world_ = std::make_unique<World>(program_, phrases_);
  world_->open();
}

// The previous turn ends when the next one begins.
void Player::turn(const Line& line) {
  end_turn();
  ++counts_.turns;
  turn_ = line.fields[0];
  said_before_ = world_->said.size();
}

// The turn goes back to a topic that was left: its slots must have been kept.
void Player::returns(const Line& line) {
  ++counts_.returns;
  returned_to_ = line.fields[0];
}

void Player::calls(const Line& line) {
  world_->writes_succeed = line.fields[0] == "succeed";
}

void Player::act(const Line& line) {
  const auto& topic = line.fields[1];
  acts_.push_back(act_of(line.fields[0], topic, line.fields[2] == "yes"));
  if (!topic.empty())
    acted_on_[topic];
}

// Values are immutable, so the act is copied, changed and put back.
void Player::slot(const Line& line) {
  if (acts_.empty())
    return;
  const auto last = acts_.back();
  auto act = *last.if_map();
  auto slots = *last["slots"].if_map();
  slots.set(line.fields[0], line.fields[1]);
  acted_on_[last["topic"].text()][line.fields[0]] = line.fields[1];
  act.set("slots", std::move(slots));
  acts_.back() = std::move(act);
}

void Player::say(const Line&) {
  utter(std::exchange(acts_, {}));
}

void Player::wait(const Line& line) {
  const auto time = parse_number(line.fields[0]).number_or(0);
  if (!world_->advance(Milliseconds(static_cast<std::int64_t>(time))))
    fault(FaultKind::endless);
}

void Player::utter(List acts) {
  spoke_ = true;
  if (!world_->say(std::move(acts)))
    fault(FaultKind::endless);
}

// -- what must hold -----------------------------------------------------------

// The slots that the lines `is` do not name must be empty.
void Player::state(const Line& line) {
  ++counts_.states;
  compared_ = line.fields[0];
  left_to_compare_ = slots_of(compared_);
}

// `*` accepts any value. The first way is the one that a fault shows.
void Player::is(const Line& line) {
  const auto& name = line.fields[0];
  auto ways = line.fields.begin() + 1;
  const auto found = std::exchange(left_to_compare_[name], {});
  if (*ways == "*")
    return;
  ++counts_.slots;
  if (std::find(ways, line.fields.end(), found) == line.fields.end())
    compare(name, *ways, found);
}

void Player::close_state() {
  for (const auto& [slot, found] : std::exchange(left_to_compare_, {}))
    if (!found.empty())
      compare(slot, {}, found);
}

// Reports a wrong slot. If the topic was returned to, and this turn did not act
// on the slot, its earlier value should have been kept: that is a second fault.
void Player::compare(const std::string& slot, const std::string& wanted,
                     const std::string& found) {
  fault(FaultKind::wrong, compared_, slot, wanted, found);
  const auto left = known_.find(compared_);
  if (compared_ != returned_to_ || left == known_.end() ||
      acted_on_[compared_].contains(slot))
    return;
  const auto& before = left->second.at(slot);
  if (!before.empty() && before != found)
    fault(FaultKind::lost, compared_, slot, before, found);
}

// Other outputs may come between, but the order of the lines must hold.
void Player::said(const Line& line) {
  const auto& outputs = world_->said;
  const auto found =
      std::find_if(outputs.begin() + static_cast<std::ptrdiff_t>(looked_at_),
                   outputs.end(), [&](const dialogue::Output& output) {
                     return output.text == line.fields[0];
                   });
  if (found == outputs.end())
    fault(FaultKind::unsaid, {}, {}, line.fields[0],
          outputs.empty() ? "" : outputs.back().text);
  else
    looked_at_ = static_cast<std::size_t>(found - outputs.begin()) + 1;
}

void Player::topic(const Line& line) {
  const auto current = world_->conversation->current_topic();
  if (current != line.fields[0])
    fault(FaultKind::elsewhere, line.fields[0], {}, line.fields[0], current);
}

// Compares the slots of a topic with those it had when it was left.
void Player::keeps(const Line& line) {
  const auto& topic = line.fields[0];
  ++counts_.returns;
  const auto now = slots_of(topic);
  for (const auto& [slot, before] : known_[topic])
    if (!before.empty() && now.at(slot) != before)
      fault(FaultKind::lost, topic, slot, before, now.at(slot));
}

// -- a user who answers what is asked -----------------------------------------

void Player::answer(const Line& line) {
  if (!answer_question(line.fields[0]))
    fault(FaultKind::unasked, line.fields[0]);
}

// Answers questions until another topic is the current one.
void Player::fill(const Line& line) {
  const auto& topic = line.fields[0];
  const auto& conversation = *world_->conversation;
  for (int i = 0; i < max_answers && conversation.current_topic() == topic; ++i)
    if (!answer_question(topic))
      break;
  if (conversation.current_topic() == topic)
    fault(FaultKind::unasked, topic);
}

// Finds the last output that asks for a slot of the topic.
bool Player::answer_question(const std::string& topic) {
  (void)world_->advance(listening);
  const auto id = program_->topic(topic);
  const auto& outputs = world_->said;
  const auto asked =
      std::find_if(outputs.rbegin(), outputs.rend(), [&](const auto& output) {
        return output.topic == id && output.slot != script::no_id;
      });
  if (asked == outputs.rend())
    return false;
  const auto& slot = program_->topics[id].slots[asked->slot].name;
  auto act = act_of("inform", topic, true);
  act.set("slots", Map{{slot, any_answer}});
  acted_on_[topic][slot] = any_answer;
  utter({std::move(act)});
  return true;
}

// -- bookkeeping --------------------------------------------------------------

// A turn without any output is a dead end.
void Player::end_turn() {
  close_state();
  for (const auto& [topic, slots] : std::exchange(acted_on_, {}))
    if (program_->topic(topic) != script::no_id)
      known_[topic] = slots_of(topic);
  if (std::exchange(spoke_, false) && world_->said.size() == said_before_)
    fault(FaultKind::silent);
  for (; world_ && errors_told_ < world_->errors.size(); ++errors_told_)
    fault(FaultKind::error, {}, {}, {}, world_->errors[errors_told_]);
  returned_to_.clear();
}

Player::Slots Player::slots_of(const std::string& topic) const {
  Slots slots;
  if (const auto id = program_->topic(topic); id != script::no_id)
    for (const auto& slot : program_->topics[id].slots)
      slots[slot.name] = text_of(world_->slot(topic, slot.name));
  return slots;
}

void Player::fault(FaultKind kind, std::string topic, std::string slot,
                   std::string wanted, std::string found) {
  tell_({kind, name_, turn_, std::move(topic), std::move(slot),
         std::move(wanted), std::move(found)});
}

} // namespace parlour::tools::corpus
