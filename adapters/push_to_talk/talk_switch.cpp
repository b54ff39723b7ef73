#include "adapters/push_to_talk/talk_switch.hpp"

namespace parlour::adapters {

TalkSwitch::Change TalkSwitch::talk(bool talks) {
  if (talks == talks_)
    return std::nullopt;
  talks_ = talks;
  return talks;
}

TalkSwitch::Change TalkSwitch::pressed() {
  return talk(by_ == TalkBy::hold || !talks_);
}

TalkSwitch::Change TalkSwitch::released() {
  return by_ == TalkBy::hold ? talk(false) : std::nullopt;
}

TalkSwitch::Change TalkSwitch::typed(Moment now) {
  // Between a press and its first repetition more time passes than between the
  // others.
  const bool repeats =
      typed_ && now - *typed_ < (repeats_ ? repetition : first_repetition);
  typed_ = now;
  repeats_ = repeats;
  if (by_ == TalkBy::twice)
    return repeats ? std::nullopt : talk(!talks_);
  due_ = now + (talks_ ? repetition : first_repetition);
  return talk(true);
}

TalkSwitch::Change TalkSwitch::passed(Moment now) {
  if (!due_ || now < *due_)
    return std::nullopt;
  due_.reset();
  return talk(false);
}

TalkSwitch::Change TalkSwitch::reset() {
  due_.reset();
  typed_.reset();
  repeats_ = false;
  return talk(false);
}

} // namespace parlour::adapters
