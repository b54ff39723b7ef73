#include "script/dialogue/topics/topic_order.hpp"

#include <algorithm>

namespace parlour::dialogue {

TopicOrder::TopicOrder(const script::Program& program)
    : program_(&program), registered_(program.topics.size(), true),
      started_(program.topics.size(), false) {}

void TopicOrder::register_topic(TopicId topic) {
  if (topic < registered_.size())
    registered_[topic] = true;
}

void TopicOrder::unregister_topic(TopicId topic) {
  if (!registered(topic))
    return;
  completed(topic);
  registered_[topic] = false;
}

bool TopicOrder::registered(TopicId topic) const {
  return topic < registered_.size() && registered_[topic];
}

// A part of another topic only while it goes on.
bool TopicOrder::takes_acts(TopicId topic) const {
  return registered(topic) && (!program_->topics[topic].is_part ||
                               current_ == topic || unfinished(topic));
}

std::vector<TopicId> TopicOrder::deaf() const {
  std::vector<TopicId> topics;
  for (TopicId topic = 0; topic < registered_.size(); ++topic)
    if (!takes_acts(topic))
      topics.push_back(topic);
  return topics;
}

std::optional<TopicId> TopicOrder::current() const {
  return current_;
}

std::optional<TopicId> TopicOrder::latest() const {
  return latest_;
}

// A current enquiry that the user leaves is not suspended: it would come back
// after silence, unasked. It is, though, if it waits for the new topic.
std::optional<TopicId> TopicOrder::activate(TopicId topic) {
  std::optional<TopicId> left;
  if (current_ && *current_ != topic &&
      (unfinished(*current_) || needs(*current_, topic))) {
    left = current_;
    suspended_.insert(suspended_.begin(), *current_);
  }
  std::erase(suspended_, topic);
  current_ = latest_ = topic;
  started_[topic] = true;
  return left;
}

void TopicOrder::completed(TopicId topic) {
  std::erase(suspended_, topic);
  if (current_ == topic)
    current_.reset();
  if (resting_ == topic)
    resting_.reset();
}

void TopicOrder::answered(TopicId topic, Timestamp now) {
  completed(topic);
  resting_ = topic;
  rested_at_ = now;
}

std::optional<TopicId> TopicOrder::resting(Timestamp now,
                                           Milliseconds context_for) const {
  if (now - rested_at_ >= context_for.count())
    return std::nullopt;
  return resting_;
}

const std::vector<TopicId>& TopicOrder::suspended() const {
  return suspended_;
}

bool TopicOrder::needs(TopicId topic, TopicId other) const {
  const auto& names = program_->topics[topic].needs;
  return program_->topics[topic].has_part(other) ||
         std::find(names.begin(), names.end(), program_->topics[other].name) !=
             names.end();
}

// Enquiries are never unfinished (engine rule 5, "Kinds"), except while they
// wait for a topic that they need.
bool TopicOrder::unfinished(TopicId topic) const {
  if (std::find(suspended_.begin(), suspended_.end(), topic) !=
      suspended_.end())
    return true;
  return current_ == topic &&
         program_->topics[topic].kind == script::TopicKind::task;
}

// Suspended topics come first, since the user has begun them. "user" as
// initiative leaves the lead to the user here, too, whatever `resume` says.
std::optional<TopicOrder::Next> TopicOrder::next() const {
  for (auto topic : suspended_) {
    const auto& definition = program_->topics[topic];
    if (definition.resume != script::ResumePolicy::never &&
        definition.initiative != script::Initiative::user)
      return Next{topic, true};
  }
  for (TopicId topic = 0; topic < registered_.size(); ++topic)
    if (registered_[topic] && !started_[topic] &&
        !program_->topics[topic].is_part &&
        program_->topics[topic].initiative == script::Initiative::system)
      return Next{topic, false};
  return std::nullopt;
}

} // namespace parlour::dialogue
