// Renames: what the topics, slots, states, variables and bodies of one program
// are in another one: those of the same names (engine rule 7.12). Made once for
// all sessions that go over.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "script/program/program.hpp"

namespace parlour::dialogue {

// Immutable once made, so sessions of several threads can share it. Keeps both
// programs alive.
class Renames {
public:
  using Program = std::shared_ptr<const script::Program>;

  Renames(Program from, Program to);

  // All of these give no_id, or no_code, where there is none of that name.
  script::TopicId topic(script::TopicId id) const;
  script::SlotId slot(script::TopicId of, script::SlotId id) const;
  script::StateId state(script::StateId id) const;
  // A variable that keeps its value; constants do not.
  std::uint32_t variable(std::uint32_t id) const;
  // A body by the name of the place where it stands; a timer's by the timer's
  // name, wherever it is started. It takes the same arguments. So a timer that
  // was moved to another file still rings.
  script::CodeId code(script::CodeId id) const;

  const script::Program& from() const {
    return *from_;
  }
  const Program& to() const {
    return to_;
  }

private:
  // Fills codes_, from the names of the bodies.
  void match_codes();

  const Program from_;
  const Program to_;
  // By the id in the first program: the id in the other one, or no_id.
  std::vector<script::TopicId> topics_;
  std::vector<std::vector<script::SlotId>> slots_; // by topic
  std::vector<script::StateId> states_;
  std::vector<std::uint32_t> variables_;
  std::vector<script::CodeId> codes_;
};

} // namespace parlour::dialogue
