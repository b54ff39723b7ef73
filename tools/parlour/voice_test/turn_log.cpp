#include "tools/parlour/voice_test/turn_log.hpp"

#include <algorithm>
#include <utility>

#include "tools/parlour/talk/act_text.hpp"

namespace parlour::tools {

namespace {

constexpr std::int64_t usual_word = 300; // ms

std::uint64_t utterance_of(const Message& message) {
  return message.params.empty()
             ? 0
             : static_cast<std::uint64_t>(message.params[0].integer_or(0));
}

} // namespace

void TurnLog::begin_row() {
  begun_ = ended_ = recognised_ = 0;
  answers_.clear();
  heard_.clear();
  understood_.clear();
  latencies_.clear();
  line_end_.reset();
  decided_.reset();
}

void TurnLog::line_ended(Timestamp now) {
  line_end_ = now;
}

void TurnLog::released(std::uint64_t id, std::string text) {
  speaking_.insert(id);
  answers_.push_back({id, std::move(text)});
}

// What is sent to sinks is no report.
void TurnLog::note(const Inspection& seen, RealTime real) {
  if (seen.kind == InspectionKind::message && seen.message &&
      seen.message->sinks.empty())
    note_message(*seen.message, real);
}

void TurnLog::note_message(const Message& message, RealTime real) {
  const auto& what = message.command;
  if (what == "TurnStarted") {
    ++begun_;
  } else if (what == "TurnEnded") {
    ++ended_;
    decided_ = message.time;
    decided_real_ = real;
  } else if (what == "TurnDropped") {
    --begun_;
  } else if (what == "RecognitionResult") {
    ++recognised_;
    heard_.push_back(message.params.empty() ? "" : message.params[0].text());
  } else if (what == "Rejected") {
    ++recognised_;
    heard_.emplace_back();
    decided_.reset(); // there is nothing to answer
  } else if (what == "FrameInfo") {
    std::string acts;
    for (const auto& act : message.params)
      acts += (acts.empty() ? "" : "; ") + act_text_without_confidence(act);
    understood_.push_back(std::move(acts));
  } else if (what == "NoResult") {
    understood_.emplace_back("nothing");
  } else {
    note_speaker(message, real);
  }
}

// Speaker.Finished has four parameters, that of the voice one.
void TurnLog::note_speaker(const Message& message, RealTime real) {
  const auto id = utterance_of(message);
  if (message.command == "Mark" && message.params.size() >= 3) {
    marks_[id].push_back(message.params[2].integer_or(0));
  } else if (message.command == "Started" && speaking_.contains(id)) {
    sounding_.insert(id);
    playing_ = id;
    started_ = message.time;
    first_sound(message.time, real);
  } else if (message.command == "Finished" && message.params.size() >= 3) {
    speaking_.erase(id);
    sounding_.erase(id);
    marks_.erase(id);
    if (message.params[2])
      interrupted_.insert(id);
  }
}

std::size_t TurnLog::words_said(Timestamp now) const {
  if (sounding_.empty())
    return 0;
  const auto marks = marks_.find(playing_);
  // The voice does not say where words begin.
  if (marks == marks_.end())
    return static_cast<std::size_t>((now - started_) / usual_word);
  const auto begun = std::ranges::count_if(
      marks->second, [&](auto mark) { return mark <= now - started_; });
  // The last of them still sounds.
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(begun, 1)) - 1;
}

void TurnLog::first_sound(Timestamp now, RealTime real) {
  if (!decided_ || !line_end_ || in_turn())
    return;
  latencies_.push_back(
      {Milliseconds(*decided_ - *line_end_), Milliseconds(now - *decided_),
       std::chrono::duration_cast<Milliseconds>(real - decided_real_)});
  decided_.reset();
}

std::vector<std::string> TurnLog::answers() const {
  std::vector<std::string> texts;
  for (const auto& answer : answers_)
    if (!interrupted_.contains(answer.id))
      texts.push_back(answer.text);
  return texts;
}

} // namespace parlour::tools
