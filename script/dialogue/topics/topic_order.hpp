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

class TopicOrder {
public:
  explicit TopicOrder(const script::Program& program); // all are registered

  void register_topic(TopicId topic);
  void unregister_topic(TopicId topic);
  bool registered(TopicId topic) const;
  std::vector<TopicId> unregistered() const;

  std::optional<TopicId> current() const;
  // The current one, else the one that was it last, completed or not.
  std::optional<TopicId> latest() const;
  // The topic that becomes suspended by it, if any: the current one, where it
  // is an unfinished task or needs this topic.
  std::optional<TopicId> activate(TopicId topic);
  void completed(TopicId topic); // or cancelled: forgotten
  // An enquiry: its slots are context for a while.
  void answered(TopicId topic, Timestamp now);
  // The enquiry whose slots are context, unless its time is over.
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
  bool unfinished(TopicId topic) const;
  // Whether `topic` names the other one in its `needs`.
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
  std::vector<bool> registered_;
  std::vector<bool> started_;
  std::optional<TopicId> current_;
  std::optional<TopicId> latest_;
  std::vector<TopicId> suspended_;
  std::optional<TopicId> resting_;
  Timestamp rested_at_ = 0;
};

} // namespace parlour::dialogue
