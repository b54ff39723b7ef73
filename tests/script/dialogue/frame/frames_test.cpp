#include <gtest/gtest.h>

#include "script/dialogue/frame/frame_evaluator.hpp"
#include "script/dialogue/frame/frames.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct FramesOfASession : testing::Test {
  FramesOfASession()
      : world(R"xml(<var name="first" expr="1"/>
          <topic name="Plain"><slot name="A" expr="'a'"/><slot name="B"/>
          </topic>
          <topic name="Bound"><slot name="A"/>
            <constraint cond="this.A ge first" message="no"/></topic>
          <topic name="Begun"><slot name="A" expr="first + 1"/></topic>
          <topic name="Chosen"><slot name="A"><cardinality type="set">
            <value expr="first + 1"/></cardinality></slot></topic>
          <topic name="Range"><slot name="A">
            <cardinality type="range" from="first"/></slot></topic>)xml"),
        interpreter(world.program), frames(*world.program, interpreter) {
    interpreter.set_variable(0, 1);
  }

  static FrameChange set(SlotId slot, Value value) {
    FrameChange change;
    change.slot = slot;
    change.value = std::move(value);
    return change;
  }
  FrameResult at_the_actor(const FrameRequest& request) {
    return apply(*world.program, request,
                 make_frame_evaluator(world.program, request.variables, 0));
  }

  World world;
  script::Interpreter interpreter;
  Frames frames;
};

TEST_F(FramesOfASession, BeginWithInitialValues) {
  EXPECT_EQ(frames.get(0, 0).slots[0].value, "a");
  EXPECT_EQ(frames.get(0, 0).status, TopicStatus::untouched);
}

TEST_F(FramesOfASession, ARequestBringsTheFrame) {
  frames.change(0, set(1, "b"), 0);
  auto request = frames.request(0, {set(0, "c")}, 5);
  ASSERT_TRUE(request.frame);
  EXPECT_EQ(request.frame->slots[1].value, "b");
  EXPECT_EQ(request.now, 5);
  EXPECT_EQ(request.changes.size(), 1u);
  EXPECT_EQ(request.variables, nullptr);
}

TEST_F(FramesOfASession, TheAnswerTakesItsPlace) {
  frames.store(at_the_actor(frames.request(0, {}, 0)).frame);
  frames.change(0, set(1, "b"), 0);
  EXPECT_EQ(frames.get(0, 0).slots[1].value, "b");
  auto result = at_the_actor(frames.request(0, {set(0, "c")}, 0));
  EXPECT_EQ(result.frame->slots[1].value, "b");
  EXPECT_EQ(result.reports.size(), 1u);
  frames.store(result.frame);
  EXPECT_EQ(&frames.get(0, 0), result.frame.get());
}

// Another actor may answer, too: it needs to know nothing of what was before.
TEST_F(FramesOfASession, EveryRequestBringsIt) {
  frames.store(at_the_actor(frames.request(0, {set(1, "b")}, 0)).frame);
  const auto result = at_the_actor(frames.request(0, {set(0, "c")}, 0));
  EXPECT_EQ(result.frame->slots[0].value, "c");
  EXPECT_EQ(result.frame->slots[1].value, "b");
}

TEST_F(FramesOfASession, VariablesTravelWhereTheyMayBeRead) {
  for (const TopicId topic : {1u, 2u, 3u, 4u}) {
    auto request = frames.request(topic, {}, 0);
    ASSERT_TRUE(request.variables);
    EXPECT_EQ(*request.variables, List{1});
  }
}

TEST_F(FramesOfASession, WithoutAnActorAreChangedInPlace) {
  const auto* frame = &frames.get(0, 0);
  const std::vector<FrameChange> changes{set(0, "x"), set(1, "b")};
  const auto result = frames.apply(0, changes, 0);
  EXPECT_EQ(result.reports.size(), 2u);
  EXPECT_FALSE(result.frame);
  EXPECT_EQ(&frames.get(0, 0), frame);
  EXPECT_EQ(frame->slots[1].value, "b");
}

TEST_F(FramesOfASession, CountAndChangeStatusLikeAnEvent) {
  frames.set_status(0, TopicStatus::active, 0);
  frames.count_question(0, 1, 0);
  EXPECT_EQ(frames.get(0, 0).status, TopicStatus::active);
  EXPECT_EQ(frames.get(0, 0).slots[1].asked, 1u);
  EXPECT_TRUE(frames.get(0, 0).done); // it has no Functional slot
}

TEST_F(FramesOfASession, WhatWasGivenAwayStaysAsItWas) {
  const auto answered = at_the_actor(frames.request(0, {}, 0)).frame;
  frames.store(answered);
  frames.change(0, set(1, "b"), 0);
  EXPECT_EQ(answered->slots[1].value, Value());
  const auto asked = frames.request(0, {}, 0).frame;
  frames.change(0, set(1, "c"), 0);
  EXPECT_EQ(asked->slots[1].value, "b");
}

// The names of the variables that travel with the first topic. A long list,
// say, that it does not read is not copied.
std::string read_by(const std::string& topic) {
  World world("<topic name='T'><slot name='A'/>" + topic + R"xml(</topic>
      <var name="one" expr="1"/><var name="two" expr="2"/>
      <var name="three" expr="3"/>
      <function name="all_two"><return expr="two + helper(two)"/></function>
      <function name="helper"><param name="x"/>
        <return expr="x gt 5 ? all_two() : x"/></function>
      <function name="changed"><call function="helper"><var expr="three"/></call>
        <return expr="1"/></function>
      <function name="named"><param name="f"/>
        <call function="{f}" return="r"/><return expr="r"/></function>)xml");
  script::Interpreter interpreter(world.program);
  Frames frames(*world.program, interpreter);
  const auto& variables = world.program->variables;
  for (std::size_t i = 0; i < variables.size(); ++i)
    interpreter.set_variable(i, variables[i].name);
  const auto request = frames.request(0, {}, 0);
  std::string names;
  for (const auto& name : request.variables ? *request.variables : List())
    names += name.is_unknown() ? "" : name.text() + " ";
  return names;
}

TEST(VariablesForAnEvent, NoneByWhatIsConstant) {
  EXPECT_EQ(read_by(R"(<slot name="B" expr="5"/>
      <constraint cond="this.A ne this.B" message="no"/>)"),
            "");
}

TEST(VariablesForAnEvent, WhateverAnEventEvaluates) {
  EXPECT_EQ(read_by("<constraint cond='this.A gt one' message='no'/>"), "one ");
  EXPECT_EQ(read_by("<constraint cond='this.A gt 1' message='not {two}'/>"),
            "two ");
  EXPECT_EQ(read_by("<slot name='B' expr='two'/>"), "two ");
  EXPECT_EQ(read_by("<slot name='B' if='two gt 1'/>"), "two ");
  EXPECT_EQ(read_by("<slot name='B'><cardinality type='range' from='one' "
                    "to='three'/></slot>"),
            "one three ");
  EXPECT_EQ(read_by("<slot name='B'><cardinality type='set'>"
                    "<value expr='[three]'/></cardinality></slot>"),
            "three ");
}

TEST(VariablesForAnEvent, NotForQuestions) {
  EXPECT_EQ(read_by("<slot name='B' question='{one}?'/>"), "");
}

// Of two functions that call each other, each is looked at once.
TEST(VariablesForAnEvent, ByFunctions) {
  EXPECT_EQ(read_by("<slot name='B' expr='all_two()'/>"), "two ");
  EXPECT_EQ(read_by("<slot name='B' expr='changed()'/>"), "two three ");
}

TEST(VariablesForAnEvent, AllWhereANameIsComputed) {
  EXPECT_EQ(read_by("<slot name='B' expr='named(1)'/>"), "one two three ");
}

} // namespace
} // namespace parlour::dialogue
