#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

Conversation good(std::string_view text) {
  auto parsed = parse_conversation(text, "dialogues/one.txt");
  EXPECT_TRUE(parsed.errors.empty())
      << (parsed.errors.empty() ? "" : parsed.errors[0].message);
  return parsed.conversation;
}

std::vector<std::string> errors_of(std::string_view text) {
  std::vector<std::string> texts;
  for (const auto& error : parse_conversation(text, "one.txt").errors)
    texts.push_back(script::to_string(error));
  return texts;
}

Step only(std::string_view line) {
  const auto conversation = good(line);
  EXPECT_EQ(conversation.steps.size(), 1u);
  return conversation.steps.empty() ? Step{} : conversation.steps[0];
}

TEST(ConversationFile, reads_turns_with_their_lines) {
  const auto conversation =
      good("# greeting\nR: Good morning.\n\nU: Hello: there.\r\nR~ ^Hi\n");
  ASSERT_EQ(conversation.steps.size(), 3u);
  EXPECT_EQ(conversation.name, "one");
  EXPECT_EQ(conversation.steps[0].kind, StepKind::robot);
  EXPECT_EQ(conversation.steps[0].text, "Good morning.");
  EXPECT_EQ(conversation.steps[1].kind, StepKind::user);
  EXPECT_EQ(conversation.steps[1].text, "Hello: there.");
  EXPECT_EQ(conversation.steps[1].line, 4u);
  EXPECT_EQ(conversation.steps[1].written, "U: Hello: there.");
  EXPECT_EQ(conversation.steps[2].kind, StepKind::robot_pattern);
  EXPECT_EQ(conversation.steps[2].text, "^Hi");
}

TEST(ConversationFile, reads_how_a_line_is_spoken) {
  const auto spoken = only("U(voice=slt, noise=babble20): Hello: there.");
  EXPECT_EQ(spoken.kind, StepKind::user);
  EXPECT_EQ(spoken.text, "Hello: there.");
  EXPECT_EQ(spoken.voice, "slt");
  EXPECT_EQ(spoken.noise, "babble20");
  EXPECT_EQ(only("P(): by the").voice, "rms");
  const auto cut = only("B(voice=awb): [No, however] pardon?");
  EXPECT_EQ(cut.kind, StepKind::barge_in);
  EXPECT_EQ(cut.target, "No, however");
  EXPECT_EQ(cut.text, "pardon?");
  EXPECT_EQ(cut.voice, "awb");
  EXPECT_EQ(only("U: (really) so").voice, "");
  EXPECT_TRUE(is_spoken(good("U: one\nU(): two\n")));
  EXPECT_FALSE(is_spoken(good("U: one\n")));
}

TEST(ConversationFile, reads_how_long_a_turn_may_take) {
  const auto bound = only("expect first-sound < 1s");
  EXPECT_EQ(bound.kind, StepKind::expect_first_sound);
  EXPECT_EQ(bound.duration, Milliseconds(1'000));
  for (const auto* wrong : {"expect first-sound 1s", "expect first-sound < x",
                            "expect first-sound <", "U(voice=rms: hi",
                            "U(voice=): hi", "U(loud): hi", "U(): "})
    EXPECT_THAT(errors_of(wrong), testing::SizeIs(1)) << wrong;
}

TEST(ConversationFile, begins_at_nine_with_seed_one) {
  const auto conversation = good("");
  EXPECT_EQ(conversation.start, parse_timestamp("2026-11-21 09:00").value());
  EXPECT_EQ(conversation.seed, 1u);
}

TEST(ConversationFile, takes_clock_and_seed) {
  const auto conversation = good("clock 2026-12-24 18:30\nseed 42\nU: hi\n"
                                 "clock 2026-12-24 19:00");
  EXPECT_EQ(conversation.start, parse_timestamp("2026-12-24 18:30").value());
  EXPECT_EQ(conversation.seed, 42u);
  ASSERT_EQ(conversation.steps.size(), 2u);
  EXPECT_EQ(conversation.steps[1].kind, StepKind::clock);
  EXPECT_EQ(conversation.steps[1].time,
            parse_timestamp("2026-12-24 19:00").value());
}

TEST(ConversationFile, reads_a_wait) {
  EXPECT_EQ(only("wait 3s").duration, Milliseconds(3000));
  EXPECT_EQ(only("wait 200ms").duration, Milliseconds(200));
}

TEST(ConversationFile, reads_an_event) {
  const auto step = only("event ASR RecognitionResult 'good day' 0.35 x");
  EXPECT_EQ(step.kind, StepKind::event);
  EXPECT_EQ(step.target, "ASR");
  EXPECT_EQ(step.command, "RecognitionResult");
  ASSERT_EQ(step.params.size(), 3u);
  EXPECT_EQ(step.params[0], Value("good day"));
  EXPECT_EQ(step.params[1], Value(0.35));
  EXPECT_EQ(step.params[2], Value("x"));
}

TEST(ConversationFile, reads_expected_posts) {
  const auto step = only("expect post Telephone Call * \"Dr. Jeffery Ho\"");
  EXPECT_EQ(step.kind, StepKind::expect_post);
  EXPECT_EQ(step.target, "Telephone");
  EXPECT_EQ(step.command, "Call");
  ASSERT_EQ(step.params.size(), 2u);
  EXPECT_TRUE(is_wildcard(step.params[0]));
  EXPECT_EQ(step.params[1], Value("Dr. Jeffery Ho"));
}

TEST(ConversationFile, reads_expected_slots) {
  const auto step = only("expect slot Appointment.Host = Dr. Jeffery Ho");
  EXPECT_EQ(step.kind, StepKind::expect_slot);
  EXPECT_EQ(step.text, "Appointment");
  EXPECT_EQ(step.target, "Host");
  EXPECT_EQ(step.value, Value("Dr. Jeffery Ho"));
  EXPECT_TRUE(only("expect slot A.B = unknown").value.is_unknown());
}

TEST(ConversationFile, reads_expected_states) {
  EXPECT_EQ(only("expect state Welcome").text, "Welcome");
}

TEST(ConversationFile, reads_expected_rows_up_to_the_last_equals) {
  const auto step =
      only("expect sql select count(*) from m where h = 'Ho' = 1");
  EXPECT_EQ(step.kind, StepKind::expect_sql);
  EXPECT_EQ(step.text, "select count(*) from m where h = 'Ho'");
  EXPECT_EQ(step.value, Value(1));
}

TEST(ConversationFile, reads_a_byte_order_mark_away) {
  EXPECT_EQ(good("\xEF\xBB\xBFU: hi").steps.size(), 1u);
}

TEST(ConversationFile, reports_every_error_with_its_line) {
  EXPECT_THAT(
      errors_of("U:\nwait soon\n\nexpect slot Time = 1\nclock noon\nseed x\n"),
      ElementsAre("one.txt:1:1: error: U: needs what the user says",
                  "one.txt:2:1: error: wait needs a duration such as 3s or "
                  "500ms, found 'soon'",
                  "one.txt:4:1: error: expected: expect slot Topic.Slot = "
                  "value",
                  "one.txt:5:1: error: clock needs a time such as 2026-11-21 "
                  "09:00, found 'noon'",
                  "one.txt:6:1: error: seed needs a whole number, found 'x'"));
}

TEST(ConversationFile, names_the_nearest_directive) {
  EXPECT_THAT(errors_of("expct state X"),
              ElementsAre(StartsWith("one.txt:1:1: error: unknown directive "
                                     "'expct', did you mean 'expect'?")));
  EXPECT_THAT(errors_of("expect slto X.Y = 1"),
              ElementsAre(testing::HasSubstr("did you mean 'slot'?")));
  EXPECT_THAT(errors_of("waiting 3s"),
              ElementsAre(testing::HasSubstr("unknown directive 'waiting'")));
}

TEST(ConversationFile, refuses_a_bad_pattern) {
  EXPECT_THAT(errors_of("R~ (open"),
              ElementsAre(StartsWith("one.txt:1:1: error: not a regular "
                                     "expression: ")));
}

TEST(ConversationFile, refuses_open_quotes_and_missing_words) {
  EXPECT_THAT(errors_of("event ASR X 'open\nexpect post Taxi\nexpect state"),
              ElementsAre("one.txt:1:1: error: a quote is left open",
                          "one.txt:2:1: error: expected expect post MODULE "
                          "COMMAND param…",
                          "one.txt:3:1: error: expected: expect state NAME"));
}

TEST(ConversationFile, refuses_a_seed_after_the_first_turn) {
  EXPECT_THAT(errors_of("U: hi\nseed 3"),
              ElementsAre("one.txt:2:1: error: seed stands before the first "
                          "turn"));
}

TEST(ConversationFile, reads_partials_and_turns_that_barge_in) {
  const auto steps = parse_conversation("P: I am\nB: stop\nB: [Good day] no\n"
                                        "B: [Good day]",
                                        "one.txt")
                         .conversation.steps;
  ASSERT_EQ(steps.size(), 4u);
  EXPECT_EQ(steps[0].kind, StepKind::partial);
  EXPECT_EQ(steps[0].text, "I am");
  EXPECT_EQ(steps[1].kind, StepKind::barge_in);
  EXPECT_EQ(steps[1].text, "stop");
  EXPECT_EQ(steps[1].target, "");
  EXPECT_EQ(steps[2].text, "no");
  EXPECT_EQ(steps[2].target, "Good day");
  EXPECT_EQ(steps[3].text, "");
  EXPECT_THAT(errors_of("P:\nB: [Good"),
              ElementsAre(testing::HasSubstr("P: needs"),
                          testing::HasSubstr("left open")));
}

TEST(ReadConversation, reports_a_file_that_is_not_there) {
  const auto parsed = read_conversation("no/such/file.txt");
  ASSERT_EQ(parsed.errors.size(), 1u);
  EXPECT_EQ(parsed.errors[0].message,
            "this file cannot be read: No such file or directory");
  EXPECT_EQ(parsed.errors[0].place.file, "no/such/file.txt");
}

TEST(ParseConversation, says_once_that_a_text_is_not_utf_8) {
  const auto parsed = parse_conversation("U: hi\nR: Caf\xe9\nX\n\xff\n", "x");
  ASSERT_EQ(parsed.errors.size(), 1u);
  EXPECT_EQ(parsed.errors[0].place.line, 2u);
  EXPECT_THAT(parsed.errors[0].message, testing::HasSubstr("not UTF-8"));
}

TEST(ReadConversation, reads_a_file) {
  test::TemporaryFolder folder;
  folder.write("two.txt", "U: hi\n");
  const auto parsed = read_conversation(folder.path() / "two.txt");
  EXPECT_TRUE(parsed.errors.empty());
  EXPECT_EQ(parsed.conversation.name, "two");
  EXPECT_EQ(parsed.conversation.steps.size(), 1u);
}

TEST(ParseLiteral, reads_values) {
  EXPECT_EQ(parse_literal("12"), Value(12));
  EXPECT_EQ(parse_literal("10:30"), Value("10:30"));
  EXPECT_EQ(parse_literal("'a b'"), Value("a b"));
  EXPECT_EQ(parse_literal("a b"), Value("a b"));
  EXPECT_EQ(parse_literal("'a' and 'b'"), Value("'a' and 'b'"));
}

} // namespace
} // namespace parlour::tools
