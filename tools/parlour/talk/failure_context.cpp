// Collects inspections; trace.cpp makes lines of them.
#include "tools/parlour/talk/failure_context.hpp"

#include "tools/parlour/talk/act_text.hpp"
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

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
