#include "script/dialogue/agenda/saved_step.hpp"
#include "script/dialogue/agenda/step_list.hpp"
#include "tests/script/dialogue/saved/round_trip.hpp"

namespace parlour::dialogue {
namespace {

// A step with all that its takers rely on.
template <class Kind>
Kind sound() {
  Kind step;
  if constexpr (requires { step.topic; })
    step.topic = 0;
  if constexpr (requires { step.slot; })
    step.slot = 1;
  if constexpr (requires { step.state; })
    step.state = 0;
  if constexpr (requires { step.turn; })
    step.turn = 7;
  if constexpr (requires { step.act; })
    step.act = std::make_shared<const Act>();
  if constexpr (requires { step.outcome; })
    step.outcome = std::make_shared<Expected<Value>>(Value(1));
  if constexpr (requires { step.ring; })
    step.ring = std::make_shared<Ring>();
  if constexpr (requires { step.body; })
    step.body.code = 0;
  if constexpr (requires { step.result; }) {
    FrameResult result;
    result.reports.resize(1);
    result.reports[0].slot = 1;
    step.result = std::make_shared<const FrameResult>(std::move(result));
  }
  return step;
}

// The small program with a code and a rule.
std::shared_ptr<const script::Program> program() {
  auto program = std::make_shared<script::Program>(*small_program());
  program->code.resize(1);
  program->topics[0].rules.resize(1);
  program->topics[0].slots[1].part = 0;
  return program;
}

template <class Kind>
std::string error_of(const Kind& step) {
  Step again;
  const auto done = read(program(), again, bytes_of(program(), Step(step)));
  return done ? "" : done.error().message;
}

// Each kind of the table but the one that needs a topic with queries.
template <class Kind>
void comes_back() {
  if constexpr (!std::same_as<Kind, steps::LookedUp>) {
    const Step step = sound<Kind>();
    const auto bytes = bytes_of(program(), step);
    Step again = steps::End();
    const auto done = read(program(), again, bytes);
    ASSERT_TRUE(done) << step.index() << ": " << done.error().message;
    EXPECT_EQ(again.index(), step.index());
    EXPECT_EQ(turn_of(again), turn_of(step));
    EXPECT_EQ(bytes_of(program(), again), bytes);
  }
}

template <class... Kinds>
void each_comes_back(std::type_identity<std::variant<Kinds...>>) {
  (comes_back<Kinds>(), ...);
}

TEST(SavedStep, EachKindComesBack) {
  each_comes_back(std::type_identity<Step>());
}

TEST(SavedStep, KeepsWhatItsListShares) {
  StepList list;
  const auto ring = std::make_shared<Ring>();
  list.add(steps::RunTimer{{.code = 0}, ring});
  list.add(steps::Conclude{3, ring});
  StepList again;
  const auto done = read(program(), again, bytes_of(program(), list));
  ASSERT_TRUE(done) << done.error().message;
  const auto first = again.take();
  const auto second = again.take();
  EXPECT_TRUE(again.empty());
  EXPECT_EQ(std::get<steps::RunTimer>(first->step).ring,
            std::get<steps::Conclude>(second->step).ring);
}

TEST(SavedStep, WhatATakerReliesOnIsThere) {
  EXPECT_EQ(error_of(steps::Cancel{}), "");
  EXPECT_NE(error_of(steps::Complete{}), "");
  EXPECT_NE(error_of(steps::Complete{.topic = 1}), "");
  EXPECT_NE(error_of(steps::TakeAct{}), "");
  EXPECT_NE(error_of(steps::Run{}), "");
  EXPECT_NE(error_of(steps::Run{{.code = 1}}), "");
  EXPECT_NE(error_of(steps::Enter{}), "");
  EXPECT_NE(error_of(steps::Ask{.topic = 0}), "");
  EXPECT_NE(error_of(steps::ResumeWait{}), "");
  EXPECT_NE(error_of(steps::LookedUp{.topic = 0}), "");
  EXPECT_NE(error_of(steps::Rule{.topic = 0, .index = 1}), "");
  auto report = sound<steps::Report>();
  report.index = 1;
  EXPECT_NE(error_of(report), "");
}

} // namespace
} // namespace parlour::dialogue
