// Hosts for where there is no conversation. Those who know more (a frame, a
// message) override what they know.
#pragma once

#include <string>
#include <utility>

#include "script/host.hpp"

namespace parlour::script {

// The world without a conversation: no slots, nothing of the system, no agents.
class LonelyHost : public Host {
public:
  Value slot(TopicId, SlotId) const override {
    return {};
  }
  void set_slot(TopicId, SlotId, Value) override {}
  Value system(const Activation&, SystemVariable) const override {
    return {};
  }
  bool online(const std::string&) const override {
    return false;
  }
};

// The world of a script that may only compute: a condition, a text, a
// constraint. It has a time, and everything else is unknown or refused.
class ComputingHost : public LonelyHost {
public:
  // `who` begins the refusal's sentence: "a phrase".
  ComputingHost(std::string who, Timestamp now)
      : who_(std::move(who)), now_(now) {}

  Performed perform(Activation&, Effect) override {
    return Error{ErrorKind::refused, who_ + " can only compute", {}};
  }
  Timestamp now() const override {
    return now_;
  }
  // A condition gives the same answer whenever it is asked.
  double random() override {
    return 0;
  }

private:
  std::string who_;
  Timestamp now_;
};

} // namespace parlour::script
