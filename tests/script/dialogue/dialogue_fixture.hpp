// Programs for tests of single parts of the dialogue. They are put together in
// C++: the "code" of a slot or topic is a function of the frame. Also a small
// version of the receptionist's topics.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "script/dialogue/frame/frame_view.hpp"
#include "script/dialogue/frame/topic_frame.hpp"

namespace parlour::dialogue {

// How a piece of code reads slots; it records which.
class SlotReader {
public:
  SlotReader(const script::Topic& topic, const TopicFrame& frame,
             std::vector<SlotId>* reads)
      : topic_(topic), frame_(frame), reads_(reads) {}

  Value operator()(std::string_view slot) const {
    auto id = topic_.slot(slot);
    if (reads_)
      reads_->push_back(id);
    return read_slot(frame_, id);
  }

private:
  const script::Topic& topic_;
  const TopicFrame& frame_;
  std::vector<SlotId>* reads_;
};

using FakeBody = std::function<Expected<Value>(const SlotReader&)>;

class Application {
public:
  script::Program program;

  CodeId code(FakeBody body) {
    bodies_.push_back(std::move(body));
    return static_cast<CodeId>(bodies_.size() - 1);
  }
  CodeId text(Value value) {
    return code([value](const SlotReader&) { return value; });
  }

  TopicId topic(std::string name,
                script::TopicKind kind = script::TopicKind::task) {
    script::Topic topic;
    topic.name = std::move(name);
    topic.kind = kind;
    program.topics.push_back(std::move(topic));
    return static_cast<TopicId>(program.topics.size() - 1);
  }

  // The reference is valid until the next slot or topic is added.
  script::Slot& slot(TopicId topic, std::string name, std::string type = "",
                     bool functional = true) {
    script::Slot slot;
    slot.name = std::move(name);
    slot.functional = functional;
    slot.cardinality.type = std::move(type);
    program.topics[topic].slots.push_back(std::move(slot));
    return program.topics[topic].slots.back();
  }

  FrameEvaluator evaluator() {
    return [this](CodeId code, const TopicFrame& frame,
                  std::vector<SlotId>* reads) {
      return bodies_.at(code)(
          SlotReader(program.topics[frame.topic], frame, reads));
    };
  }

  TopicFrame frame(TopicId topic) {
    return new_frame(program, topic, evaluator());
  }

  FrameResult change(const TopicFrame& frame,
                     std::vector<FrameChange> changes) {
    FrameRequest request;
    request.frame = std::make_shared<const TopicFrame>(frame);
    request.changes = std::move(changes);
    return apply(program, request, evaluator());
  }

  SlotId id(TopicId topic, std::string_view slot) const {
    return program.topics[topic].slot(slot);
  }

private:
  std::vector<FakeBody> bodies_;
};

inline FrameChange make(FrameChange::Kind kind, SlotId slot = script::no_id,
                        Value value = {}, Value confidence = 1.0) {
  FrameChange change;
  change.kind = kind;
  change.slot = slot;
  change.value = std::move(value);
  change.confidence = std::move(confidence);
  return change;
}

inline FrameChange fill(SlotId slot, Value value, Value confidence = 1.0) {
  return make(FrameChange::Kind::fill, slot, std::move(value),
              std::move(confidence));
}

// Appointment (a task), Facility (an enquiry) and Taxi (a task).
struct Receptionist : Application {
  TopicId appointment, facility, taxi;

  Receptionist() {
    appointment = topic("Appointment");
    slot(appointment, "Visitor");
    slot(appointment, "Organisation", "", false);
    slot(appointment, "Host", "query");
    slot(appointment, "Time", "time").question =
        text("What's the time of your appointment?");
    facility = topic("Facility", script::TopicKind::enquiry);
    slot(facility, "Category", "query");
    slot(facility, "Location", "level", false);
    script::KnowledgeSource source;
    source.kind = "db";
    source.statement = "select name, level from rr_facility";
    source.by = {{id(facility, "Category"), "category", {}, 0},
                 {id(facility, "Location"), "level", {}, 1}};
    program.topics[facility].queries.push_back(std::move(source));
    taxi = topic("Taxi");
    slot(taxi, "Destination");
    slot(taxi, "Time", "time");
  }
};

} // namespace parlour::dialogue
