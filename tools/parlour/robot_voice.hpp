// RobotVoice: robot turns as lines of an output, one each. From any thread.
#pragma once

#include <functional>
#include <iosfwd>
#include <mutex>
#include <string>

namespace parlour::tools {

class RobotVoice {
public:
  // `closed` is called once, when a line could not be written.
  RobotVoice(std::ostream& out, std::function<void()> closed);

  void say(const std::string& text);

private:
  std::mutex mutex_;
  std::ostream& out_;
  std::function<void()> closed_;
};

} // namespace parlour::tools
