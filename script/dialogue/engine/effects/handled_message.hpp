// HandledMessage: whether a reaction to a message runs, as <consume/> in it
// sees that. The pipeline says when; which message it is, is its own affair.
#pragma once

#include <utility>

namespace parlour::dialogue {

// Reactions of the pipeline lane only: what is offered to the reactions to
// Dialogue has a number instead (questions/offers.hpp). It need not be saved,
// as no reaction runs between two inputs.
class HandledMessage {
public:
  // A reaction is about to run, or to go on.
  void begins() {
    runs_ = true;
  }
  // It has ended, or waits; whether it has consumed the message meanwhile.
  bool ends() {
    runs_ = false;
    return std::exchange(consumed_, false);
  }
  // <consume/>; false where no reaction runs.
  bool consume() {
    consumed_ = runs_;
    return runs_;
  }

private:
  bool runs_ = false;
  bool consumed_ = false;
};

} // namespace parlour::dialogue
