#include <caf/scoped_actor.hpp>

#include "actors/sessions/topic_frame.hpp"
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

  static FrameRequest set(script::SlotId slot, Value value) {
    FrameRequest request;
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
      bench.spawn(topic_frame, bench.program, script::TopicId(0));
};

TEST_F(TopicFrameTest, BeginsAsTheTopicSays) {
  const auto result = ask({});
  EXPECT_TRUE(result->frame->slots.at(0).value.is_unknown());
  EXPECT_EQ(result->frame->slots.at(1).value, Value("small"));
  EXPECT_EQ(result->missing, 0u);
}

TEST_F(TopicFrameTest, KeepsWhatItWasTold) {
  const auto before = ask(set(0, "tea"))->frame;
  const auto after = ask(set(1, "large"))->frame;
  EXPECT_EQ(after->slots.at(0).value, Value("tea"));
  EXPECT_EQ(after->slots.at(1).value, Value("large"));
  EXPECT_EQ(before->slots.at(1).value, Value("small")); // immutable
}

TEST_F(TopicFrameTest, GoesOnFromTheSessionsFrame) {
  ask(set(0, "tea"));
  auto mine = *ask({})->frame;
  mine.slots.at(0).value = "coffee";
  auto request = set(1, "large");
  request.start = std::make_shared<const dialogue::Frame>(mine);
  EXPECT_EQ(ask(request)->frame->slots.at(0).value, Value("coffee"));
}

} // namespace
} // namespace parlour::actors
