#include "tools/parlour/robot_voice.hpp"

#include <ostream>
#include <utility>

#include "tools/parlour/trace.hpp"

namespace parlour::tools {

RobotVoice::RobotVoice(std::ostream& out, std::function<void()> closed)
    : out_(out), closed_(std::move(closed)) {}

void RobotVoice::say(const std::string& text) {
  std::lock_guard lock(mutex_);
  if (!out_)
    return;
  out_ << as_one_line(text) << '\n' << std::flush;
  if (!out_ && closed_)
    closed_();
}

} // namespace parlour::tools
