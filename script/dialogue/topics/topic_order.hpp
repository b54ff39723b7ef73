// TopicOrder: which topics take part, which one is current, which are
// suspended and in what order, which enquiry rests (engine rule 5, "Which topic
// next"). Plain data with rules; knows no frames and no time but what it is
// told.
#pragma once

#include <optional>
#include <vector>

#include "runtime/base/clock.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

using script::TopicId;

// TopicFrames owns it, and keeps the topics' statuses in step with it; nothing
// here looks at them. Ids must be of the program that it was made with, which
// must outlive it. At most one topic is current, at most one rests, and no
// topic is both current and suspended.
class TopicOrder {
public:
  explicit TopicOrder(const script::Program& program); // all are registered

  // By <register>. Unknown ids are ignored.
  void register_topic(TopicId topic);
  // By <unregister>: it is neither current, suspended nor resting any more, and
  // what is said is not about it.
  void unregister_topic(TopicId topic);
  bool registered(TopicId topic) const;
  // Whether what is said may be about it: it takes part, and is no part of
  // another topic (engine rule 5.15) unless that goes on.
  bool takes_acts(TopicId topic) const;
  std::vector<TopicId> deaf() const; // that take none

  // Nothing after a topic was completed, cancelled or answered, until the next
  // one begins.
  std::optional<TopicId> current() const;
  // The current one, else the one that was it last, completed or not.
  std::optional<TopicId> latest() const;
  // It becomes the current one. Returns the topic that becomes suspended by it,
  // if any: the current one, where it is an unfinished task or needs this
  // topic. The caller runs that one's <suspended>.
  std::optional<TopicId> activate(TopicId topic);
  void completed(TopicId topic); // or cancelled: forgotten
  // An enquiry rests: its slots are context for a while. The one that rested
  // before does no more.
  void answered(TopicId topic, Timestamp now);
  // The enquiry whose slots are context, unless its time is over. It is not
  // forgotten then, only no longer told.
  std::optional<TopicId> resting(Timestamp now, Milliseconds context_for) const;

  // What another program's order was, of which `rename` gives the topics here,
  // or no_id.
  template <class Rename>
  void take_over(const TopicOrder& before, Rename rename) {
    const auto renamed = [&](std::optional<TopicId> topic) {
      const auto id = topic ? rename(*topic) : script::no_id;
      return id == script::no_id ? std::nullopt : std::optional(id);
    };
    for (TopicId topic = 0; topic < before.registered_.size(); ++topic)
      if (const auto here = renamed(topic)) {
        registered_[*here] = before.registered_[topic];
        started_[*here] = before.started_[topic];
      }
    current_ = renamed(before.current_);
    latest_ = renamed(before.latest_);
    resting_ = renamed(before.resting_);
    rested_at_ = before.rested_at_;
    for (auto topic : before.suspended_)
      if (const auto here = renamed(topic))
        suspended_.push_back(*here);
  }

  // Most recently suspended first.
  const std::vector<TopicId>& suspended() const;
  // A current task, or anything that is suspended.
  bool unfinished(TopicId topic) const;
  // Whether `topic` names the other one in its `needs`, or has it as a part.
  bool needs(TopicId topic, TopicId other) const;

  // What comes after silence: the most recently suspended task that may
  // resume (not one that never asks), else the next registered topic with
  // initiative "system" that was not yet started, else nothing.
  struct Next {
    TopicId topic;
    bool resumes; // else it starts
  };
  std::optional<Next> next() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(program_);
    archive(registered_, started_, rested_at_);
    archive.topic(current_);
    archive.topic(latest_);
    archive.topics(suspended_);
    archive.topic(resting_);
  }

private:
  const script::Program* program_;
  // By topic.
  std::vector<bool> registered_;
  // By topic: begun once in this session, whatever became of it.
  std::vector<bool> started_;
  std::optional<TopicId> current_;
  std::optional<TopicId> latest_;
  // The latest first.
  std::vector<TopicId> suspended_;
  std::optional<TopicId> resting_;
  // When resting_ was answered.
  Timestamp rested_at_ = 0;
};

} // namespace parlour::dialogue
