// Hosts for scripts that run without a conversation. A subclass overrides what
// it knows, such as a frame or a message.
#pragma once

#include <string>
#include <string_view>

#include "script/program/host.hpp"

namespace parlour::script {

// A host without slots, system variables and agents.
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

// A host for scripts that may only compute: conditions, texts, constraints. It
// has a time; every effect is refused.
class ComputingHost : public LonelyHost {
public:
  // `who` begins the sentence of the refusal: "a phrase". It must outlive the
  // host.
  ComputingHost(std::string_view who, Timestamp now) : who_(who), now_(now) {}

  Performed perform(Activation&, const Effect&) override {
    return Error{
        ErrorKind::refused, std::string(who_) + " can only compute", {}};
  }
  // Constant, as it is given once.
  Timestamp now() const override {
    return now_;
  }
  // A condition must give the same answer each time.
  double random() override {
    return 0;
  }

private:
  std::string_view who_; // a literal
  Timestamp now_;
};

} // namespace parlour::script
