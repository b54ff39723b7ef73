// The two workloads of the dialogue engine alone: turns of the user through
// topics and frames, fed with acts, and events through a state machine. No
// actor, no understanding, no database.
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/base/error.hpp"
#include "script/program/program.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

class DialogueWorkload {
public:
  // The error names the first finding.
  static Expected<DialogueWorkload> load(const std::filesystem::path& file);

  // The six turns of turns.xml, in a new conversation each time; the result
  // is how many characters were said in one conversation.
  Expected<Measured> turns(int conversations) const;

  // Events Robot.Next to events.xml; the result is the state at the end.
  Expected<Measured> events(int count) const;

private:
  explicit DialogueWorkload(std::shared_ptr<const script::Program> program)
      : program_(std::move(program)) {}

  std::shared_ptr<const script::Program> program_;
};

} // namespace parlour::tools
