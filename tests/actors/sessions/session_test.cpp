#include <stdexcept>

#include "actors/sessions/session.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

// Understands "<slot> <value>" as an act that informs.
std::vector<Answer> understand(const Message& message) {
  const auto text = message.params.at(0).text();
  const auto blank = text.find(' ');
  if (blank == std::string::npos)
    throw std::runtime_error("one word is too few");
  Map slots{{text.substr(0, blank), text.substr(blank + 1)}};
  Map act{{act_key::topic, "Order"},
          {act_key::act, "inform"},
          {act_key::confidence, 1},
          {act_key::slots, slots},
          {act_key::text, text}};
  return {{"FrameInfo", {act}}};
}

constexpr const char* order = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <post module="NLU" command="DoNLU" param="_LPARAM1"/>
    </RecognitionResult></ASR>
    <NLU><FrameInfo><fire param="_LPARAMS"/></FrameInfo>
         <Failed><speak param="understanding failed"/></Failed></NLU>
  </component></messages></handler>
  <topic name="Order">
    <slot name="Drink" type="Functional" question="Which drink?"/>
    <slot name="Size" type="Functional" question="Which size?">
      <cardinality type="set"><value>small</value><value>large</value>
      </cardinality>
    </slot>
    <filled><speak param="One {this.Size} {this.Drink}."/></filled>
  </topic>)";

class SessionTest : public NodeFixture {
protected:
  void start_order() {
    options.components = {inline_component("Words", "NLU", understand)};
    start(order);
  }
};

TEST_F(SessionTest, FillsAFrameByItsActorAndAsksOn) {
  start_order();
  EXPECT_THAT(say({"Drink tea"}), ElementsAre("Which size?"));
  auto session = node->session_at(seat);
  EXPECT_EQ(node->slot_value(session, "Order", "Drink"), Value("tea"));
  EXPECT_THAT(say({"Size large"}), ElementsAre("One large tea."));
}

// What arrives together is known before a question is released.
TEST_F(SessionTest, WithdrawsAQuestionWhenTheUserGoesOn) {
  start_order();
  EXPECT_THAT(say({"Drink tea", "Size small"}), ElementsAre("One small tea."));
}

TEST_F(SessionTest, DoesTheSameInRealTime) {
  options.virtual_start.reset();
  start_order();
  EXPECT_THAT(say({"Drink tea", "Size small"}), ElementsAre("One small tea."));
}

TEST_F(SessionTest, HearsOfAnInlineComponentThatThrows) {
  start_order();
  EXPECT_THAT(say({"what"}), ElementsAre("understanding failed"));
  EXPECT_THAT(logs, ElementsAre("Words failed: one word is too few"));
  EXPECT_THAT(say({"Drink tea"}), ElementsAre("Which size?"));
}

TEST_F(SessionTest, ShowsInlineMessagesAsAllOthers) {
  start_order();
  say({"Drink tea"});
  EXPECT_THAT(ways_of("DoNLU"), ElementsAre(HasSubstr("| -> NLU")));
  EXPECT_THAT(ways_of("FrameInfo"), ElementsAre(HasSubstr("| session")));
}

TEST_F(SessionTest, EqualInputsGiveEqualRuns) {
  std::vector<std::vector<std::string>> runs;
  for (int i = 0; i < 2; ++i) {
    ways.clear();
    options.virtual_start = nine_o_clock;
    options.seed = 1;
    start_order();
    say({"Drink tea", "nonsense", "Size small"});
    node->stop();
    runs.push_back(ways);
  }
  EXPECT_EQ(runs[0], runs[1]);
}

// What its port throws (words that cannot be found) ends that session: a log
// line says so, its seat may begin again, and the others do not notice.
TEST_F(SessionTest, EndsWithALogLineWhenItsPortThrows) {
  class Throwing : public PhraseEvaluator {
    Rendering render(const Value&) const override {
      throw std::runtime_error("no dictionary");
    }
  };
  options.phrases = std::make_shared<Throwing>();
  start(R"(<handler name="H"><messages><component><ASR><RecognitionResult>
      <if cond="_LPARAM1 == 'fail'"><throw expr="'oops'"/></if>
      <speak param="You said: {_LPARAM1}"/>
    </RecognitionResult></ASR></component></messages></handler>)");
  const auto other = node->open_seat({[](auto&, auto&) {}, {}});
  node->enter(other, {"hello"});
  say({"hello"});
  const auto lost = node->session_at(seat);
  EXPECT_THAT(say({"fail", "never heard"}), IsEmpty());
  EXPECT_THAT(logs, ElementsAre(testing::AllOf(
                        HasSubstr("session " + lost + " was lost: "),
                        HasSubstr("no dictionary"))));
  EXPECT_EQ(over, 1);
  EXPECT_EQ(node->session_at(seat), "");
  EXPECT_NE(node->session_at(other), "");
  EXPECT_THAT(say({"again"}), ElementsAre("You said: again"));
}

TEST_F(SessionTest, ManySessionsDoNotMix) {
  options.virtual_start.reset();
  start_order();
  std::vector<SeatId> seats;
  for (int i = 0; i < 50; ++i) {
    seats.push_back(node->open_seat({[](auto&, auto&) {}, {}}));
    node->enter(seats.back(), {"Drink tea " + std::to_string(i)});
  }
  node->run_until_quiet();
  for (int i = 0; i < 50; ++i)
    EXPECT_EQ(
        node->slot_value(node->session_at(seats[static_cast<std::size_t>(i)]),
                         "Order", "Drink"),
        Value("tea " + std::to_string(i)));
}

} // namespace
} // namespace parlour::actors
