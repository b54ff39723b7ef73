// HandledMessage: whether a reaction to a message runs, as <consume/> in it
// sees that. The pipeline says when; which message it is, is its own affair.
#pragma once

#include <utility>

namespace parlour::dialogue {

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
