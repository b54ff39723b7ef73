// PushedStates: what the topic engine asks of the states that scripts pushed.
#pragma once

#include "script/program/program.hpp"

namespace parlour::dialogue {

class PushedStates {
public:
  // Whether a script of this topic waits for a pushed state.
  virtual bool was_pushed_by(script::TopicId topic) const = 0;
  // Leaves the pushed levels, whose activations were cancelled.
  virtual void clear_pushed() = 0;

protected:
  ~PushedStates() = default;
};

} // namespace parlour::dialogue
