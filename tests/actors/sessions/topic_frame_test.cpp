#include <caf/scoped_actor.hpp>

#include "actors/sessions/topic_frame.hpp"
#include "script/dialogue/frame/frame_evaluator.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

using dialogue::FrameChange;
using dialogue::FrameRequest;

class TopicFrameTest : public testing::Test {
protected:
  std::shared_ptr<const dialogue::FrameResult> ask(FrameRequest request) {
    caf::scoped_actor self(*bench.system);
    auto answer = self->request(
        frame, caf::infinite,
        apply_changes{std::make_shared<const FrameRequest>(std::move(request)),
                      bench.work()});
    bench.run();
    std::shared_ptr<const dialogue::FrameResult> result;
    answer.receive([&](frame_changed& what) { result = what.result; },
                   [](const caf::error&) { FAIL() << "no answer"; });
    return result;
  }

  dialogue::FramePointer new_frame() const {
    return std::make_shared<const dialogue::TopicFrame>(dialogue::new_frame(
        *bench.program, 0,
        dialogue::make_frame_evaluator(bench.program, nullptr, 0)));
  }
  static FrameRequest set(dialogue::FramePointer frame, script::SlotId slot,
                          Value value) {
    FrameRequest request;
    request.frame = std::move(frame);
    request.changes.push_back({.kind = FrameChange::Kind::set,
                               .slot = slot,
                               .value = std::move(value)});
    return request;
  }

  Bench bench{R"(<topic name="Order">
                   <slot name="Drink" type="Functional"/>
                   <slot name="Size" expr="'small'"/>
                 </topic>)"};
  topic_frame_actor frame =
      bench.spawn(topic_frame, bench.program, script::TopicId(0), ActorTrace());
};

TEST_F(TopicFrameTest, AnswersWithTheNextFrame) {
  const auto before = new_frame();
  const auto result = ask(set(before, 1, "large"));
  EXPECT_EQ(result->frame->slots.at(1).value, Value("large"));
  EXPECT_EQ(before->slots.at(1).value, Value("small")); // immutable
  EXPECT_EQ(result->missing, 0u);
}

TEST_F(TopicFrameTest, KeepsNothingOfARequest) {
  const auto first = new_frame();
  ask(set(first, 0, "tea"));
  const auto result = ask(set(first, 1, "large"));
  EXPECT_TRUE(result->frame->slots.at(0).value.is_unknown());
}

} // namespace
} // namespace parlour::actors
