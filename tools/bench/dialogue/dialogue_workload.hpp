// The workloads of `parlour bench dialogue`: user turns through topics and
// frames, given as acts, and events through a state machine. There are no
// actors, no understanding and no database.
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/base/error.hpp"
#include "script/program/program.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// Compiled once; may be run again and again.
class DialogueWorkload {
public:
  // Compiles the workload. The error has the first finding.
  static Expected<DialogueWorkload> load(const std::filesystem::path& file);

  // Plays the six turns of turns.xml, in a new conversation each time. The
  // result is the number of characters that the robot says in one conversation.
  Expected<Measured> turns(int conversations) const;

  // Sends events Robot.Next to events.xml. The result is the state at the end.
  Expected<Measured> events(int count) const;

private:
  explicit DialogueWorkload(std::shared_ptr<const script::Program> program)
      : program_(std::move(program)) {}

  std::shared_ptr<const script::Program> program_;
};

} // namespace parlour::tools
