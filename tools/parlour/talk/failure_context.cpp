// Collects inspections; trace.cpp makes lines of them.
#include "tools/parlour/talk/failure_context.hpp"

#include "runtime/message/understanding.hpp"
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

// "Time = 15:00, Place = hall" behind a colon. A slot is a value, or a map with
// `value` and, if that is unknown, `candidates`.
std::string slots_text(const Value& slots) {
  std::string text;
  const auto* map = slots.if_map();
  if (!map)
    return text;
  for (const auto& [name, given] : map->entries()) {
    const auto* parts = given.if_map();
    const auto value = parts ? given["value"] : given;
    text += (text.empty() ? ": " : ", ") + name + " = ";
    text += parts && value.is_unknown() ? to_string(given["candidates"])
                                        : to_string(value);
  }
  return text;
}

// An act in the form of FrameInfo, such as
// "inform Taxi (0.95): Time = 15:00"
std::string act_text(const Value& act) {
  auto text = act[act_key::act].text();
  if (const auto topic = act[act_key::topic]; !topic.is_unknown())
    text += " " + topic.text();
  if (const auto confidence = act[act_key::confidence];
      !confidence.is_unknown())
    text += " (" + to_string(confidence) + ")";
  return text + slots_text(act[act_key::slots]);
}

} // namespace

void FailureContext::begin_turn() {
  understood_.clear();
  recent_.clear();
}

// Only what components report counts, not what is sent to sinks.
void FailureContext::note_message(const Inspection& inspection) {
  const auto& message = *inspection.message;
  if (!message.sinks.empty())
    return;
  if (message.command == "FrameInfo")
    for (const auto& act : message.params)
      understood_.push_back(act_text(act));
  else if (message.command == "NoResult")
    understood_.emplace_back("nothing");
}

// State, topics and slots keep their last value.
void FailureContext::note(const Inspection& inspection) {
  const auto& name = inspection.subject;
  const auto& detail = inspection.detail;
  switch (inspection.kind) {
  case InspectionKind::message:
    if (inspection.message)
      note_message(inspection);
    return;
  case InspectionKind::branch:
    return;
  case InspectionKind::transition:
    state_ = name;
    break;
  case InspectionKind::topic:
    topics_[name] = detail;
    break;
  case InspectionKind::slot: {
    const auto dot = name.find('.'); // "Topic.Slot"
    slots_[name.substr(0, dot)][name.substr(dot + 1)] = detail;
    break;
  }
  default:
    break;
  }
  recent_.push_back(trace_line(inspection));
  // Only the last max_recent events are kept.
  if (recent_.size() > max_recent)
    recent_.pop_front();
}

// The labels have the same width, so that the lines form columns.
std::vector<std::string> FailureContext::lines() const {
  std::vector<std::string> lines;
  for (const auto& act : understood_)
    lines.push_back("understood  " + act);
  if (!state_.empty())
    lines.push_back("state       " + state_);
  for (const auto& [topic, status] : topics_) {
    auto line = "topic       " + topic + " " + status;
    const char* separator = ": ";
    if (const auto slots = slots_.find(topic); slots != slots_.end())
      for (const auto& [slot, value] : slots->second) {
        line += separator + slot + " = " + value;
        separator = ", ";
      }
    lines.push_back(std::move(line));
  }
  for (const auto& event : recent_)
    lines.push_back("before      " + event);
  return lines;
}

} // namespace parlour::tools
