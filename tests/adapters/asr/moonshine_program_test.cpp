#include <future>

#include <gmock/gmock.h>

#include "adapters/asr/moonshine_program.hpp"
#include "tests/adapters/asr/fake_moonshine.hpp"

namespace parlour::adapters::moonshine {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr auto patience = 60s;
const std::vector<Sample> frame(frame_samples);

class MoonshineProgramTest : public testing::Test {
protected:
  Expected<void> start(const std::string& mode) {
    fake_.emplace(mode);
    order.program = test::FakeMoonshine::interpreter();
    order.arguments = {fake_->program().string()};
    auto started = MoonshineProgram::start(
        order,
        {[this](Answer answer) { answers_.set_value(std::move(answer)); },
         [](Milliseconds) {},
         [this](const std::string& reason) { over_.set_value(reason); },
         [this](const std::string& line) {
           printed.push_back(line);
           if (printed.size() == 1)
             printed_.set_value();
         }});
    if (!started)
      return tl::make_unexpected(started.error());
    program = std::move(*started);
    return {};
  }
  // Why the program ended.
  std::string over() {
    auto reason = over_.get_future();
    return reason.wait_for(patience) == std::future_status::ready
               ? reason.get()
               : "it goes on";
  }
  // Of one turn without audio.
  std::string over_after_finish(const std::string& mode) {
    if (!start(mode))
      return "it does not start";
    program->ask(1, finish_frame(1));
    return over();
  }

  ProgramOrder order;
  std::vector<std::string> printed; // read it when the program is over
  std::unique_ptr<MoonshineProgram> program;

private:
  std::optional<test::FakeMoonshine> fake_;
  std::promise<Answer> answers_;
  std::promise<std::string> over_;
  std::promise<void> printed_; // the first line

protected:
  bool has_printed() {
    return printed_.get_future().wait_for(patience) ==
           std::future_status::ready;
  }
  Answer answer() {
    return answers_.get_future().get();
  }
};

TEST_F(MoonshineProgramTest, AnswersATurn) {
  ASSERT_TRUE(start("behaves"));
  program->send(words_frame({{"Jeffery Ho", "gym"}, 2}));
  program->ask(7, finish_frame(7));
  const auto rejected = answer();
  EXPECT_EQ(rejected.kind, AnswerKind::rejected);
  EXPECT_EQ(rejected.turn, 7);
  EXPECT_TRUE(has_printed()); // by another way than the answer's
  program.reset();
  EXPECT_THAT(printed, ElementsAre("words: Jeffery Ho;gym;"));
}

TEST_F(MoonshineProgramTest, SaysWhyItIsNeverReady) {
  ASSERT_TRUE(start("refuses"));
  EXPECT_EQ(over(), "there is no model");
}

TEST_F(MoonshineProgramTest, ItsLastWordsAreHeard) {
  ASSERT_TRUE(start("exits"));
  EXPECT_EQ(over(), "it ended with status 3");
  EXPECT_THAT(printed, ElementsAre("out of luck"));
}

TEST_F(MoonshineProgramTest, LoadingForEverIsNoticed) {
  order.ready_within = 10ms;
  order.answer_within = 60s;
  EXPECT_EQ(over_after_finish("is never ready"), "it is not ready in time");
}

TEST_F(MoonshineProgramTest, NoTimeToLoadIsNoticed) {
  order.ready_within = 0ms;
  EXPECT_EQ(over_after_finish("is never ready"), "it is not ready in time");
}

TEST_F(MoonshineProgramTest, NeedsAnInterpreter) {
  order.program = "/no/such/node";
  const auto started = MoonshineProgram::start(order, {});
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message, HasSubstr("/no/such/node"));
}

TEST_F(MoonshineProgramTest, ItsDeathIsNoticed) {
  EXPECT_EQ(over_after_finish("dies"), "it ended with status 4");
}

TEST_F(MoonshineProgramTest, NonsenseEndsIt) {
  EXPECT_EQ(over_after_finish("talks nonsense"),
            "it says what cannot be read: Traceback");
}

TEST_F(MoonshineProgramTest, ALineWithoutEndEndsIt) {
  EXPECT_EQ(over_after_finish("never ends a line"),
            "it says a line without an end");
}

TEST_F(MoonshineProgramTest, HangingIsNoticed) {
  order.answer_within = 10ms;
  EXPECT_EQ(over_after_finish("hangs"), "it does not answer");
}

TEST_F(MoonshineProgramTest, NotReadingIsNoticed) {
  order.most_unsent = 4 << 20;
  ASSERT_TRUE(start("does not read"));
  const std::vector<Sample> second(speech_rate);
  for (int seconds = 0; seconds < 300; ++seconds)
    program->send(audio_frame(1, second));
  EXPECT_EQ(over(), "it does not read what it is sent");
}

TEST_F(MoonshineProgramTest, IsEndedWhateverItDoes) {
  ASSERT_TRUE(start("does not read"));
  program.reset(); // or else this waits for it in vain
}

} // namespace
} // namespace parlour::adapters::moonshine
