// Hosts for where there is no conversation. Those who know more (a frame, a
// message) override what they know.
#pragma once

#include <string>
#include <string_view>

#include "script/program/host.hpp"

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
  ComputingHost(std::string_view who, Timestamp now) : who_(who), now_(now) {}

  Performed perform(Activation&, const Effect&) override {
    return Error{
        ErrorKind::refused, std::string(who_) + " can only compute", {}};
  }
  Timestamp now() const override {
    return now_;
  }
  // A condition gives the same answer whenever it is asked.
  double random() override {
    return 0;
  }

private:
  std::string_view who_; // a literal
  Timestamp now_;
};

} // namespace parlour::script
