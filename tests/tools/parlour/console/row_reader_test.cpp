#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/console/row_reader.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Returns the reads that the test has set, and notes how long each could wait.
class ScriptedSource : public ByteSource {
public:
  explicit ScriptedSource(std::vector<Read> reads) : reads_(std::move(reads)) {}
  Read read(std::optional<Milliseconds> patience) override {
    patiences.push_back(patience ? patience->count() : -1);
    // Without a time limit there is no silence.
    while (!patience && next_ < reads_.size() &&
           reads_[next_].kind == Read::Kind::silence)
      ++next_;
    return next_ < reads_.size() ? reads_[next_++] : Read{};
  }
  std::vector<long> patiences;

private:
  std::vector<Read> reads_;
  std::size_t next_ = 0;
};

Read bytes(std::string text) {
  return {Read::Kind::bytes, std::move(text)};
}
const Read silence{Read::Kind::silence, {}};
const Read interrupted{Read::Kind::interrupted, {}};

struct Outcome {
  std::vector<std::string> events; // "a|b", "quiet", "step", "end"
  std::vector<std::string> notes;
  std::vector<long> patiences;
};

std::string describe(const RowEvent& event) {
  switch (event.kind) {
  case RowEvent::Kind::quiet:
    return "quiet";
  case RowEvent::Kind::step:
    return "step";
  case RowEvent::Kind::end:
    return "end";
  case RowEvent::Kind::interrupted:
    return "interrupted";
  case RowEvent::Kind::turns:
    break;
  }
  std::string text;
  for (const auto& turn : event.turns)
    text += (text.empty() ? "" : "|") + turn;
  return text;
}

Outcome read_all(std::vector<Read> reads) {
  ScriptedSource source(std::move(reads));
  Outcome outcome;
  RowReader reader(
      source, [&](const std::string& note) { outcome.notes.push_back(note); });
  do
    outcome.events.push_back(describe(reader.next()));
  while (outcome.events.back() != "end" &&
         outcome.events.back() != "interrupted");
  outcome.patiences = source.patiences;
  return outcome;
}

TEST(RowReader, reads_the_rows_of_the_example) {
  EXPECT_THAT(
      read_all({bytes("one\ntwo\n\nthree\n\n\nfour\n")}).events,
      ElementsAre("one|two", "quiet", "three", "quiet", "step", "four", "end"));
}

TEST(RowReader, ends_at_the_end_of_input) {
  EXPECT_THAT(read_all({}).events, ElementsAre("end"));
  EXPECT_THAT(read_all({bytes("no line end")}).events,
              ElementsAre("no line end", "end"));
}

TEST(RowReader, ends_a_row_at_a_pause) {
  EXPECT_THAT(read_all({bytes("one\n"), silence, bytes("two\n")}).events,
              ElementsAre("one", "two", "end"));
}

TEST(RowReader, does_not_end_a_row_before_the_pause) {
  EXPECT_THAT(read_all({bytes("one\n"), bytes("two\n"), silence}).events,
              ElementsAre("one|two", "end"));
}

TEST(RowReader, waits_fifty_milliseconds_only_inside_a_row) {
  EXPECT_THAT(read_all({bytes("one\n"), silence, bytes("\n")}).patiences,
              ElementsAre(-1, 50, -1, -1));
}

TEST(RowReader, takes_an_empty_line_after_a_pause_as_the_row_s_end) {
  EXPECT_THAT(
      read_all({bytes("one\n"), silence, bytes("\n"), bytes("\n")}).events,
      ElementsAre("one", "quiet", "step", "end"));
}

// Input like that of `yes`: no pause, no empty line, no end.
TEST(RowReader, takes_a_row_without_end_in_parts) {
  std::string many;
  for (std::size_t i = 0; i < 2 * longest_row + 1; ++i)
    many += "y\n";
  ScriptedSource source({bytes(many)});
  std::vector<std::string> notes;
  RowReader reader(source,
                   [&](const std::string& note) { notes.push_back(note); });
  for (const auto& [size, is_part] :
       {std::pair(longest_row, true), {longest_row, true}, {1, false}}) {
    const auto event = reader.next();
    EXPECT_EQ(event.turns.size(), size);
    EXPECT_EQ(event.is_part, is_part);
  }
  EXPECT_EQ(reader.next().kind, RowEvent::Kind::end);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("taken in parts")));
}

TEST(RowReader, takes_long_lines_in_parts) {
  std::string many;
  for (int i = 0; i < 12; ++i)
    many += std::string(longest_line, 'x') + "\n";
  ScriptedSource source({bytes(many)});
  RowReader reader(source, [](const std::string&) {});
  EXPECT_EQ(reader.next().turns.size(), 10u);
}

TEST(RowReader, leaves_half_a_line_out_of_a_row_that_a_pause_ends) {
  EXPECT_THAT(read_all({bytes("one\ntw"), silence, bytes("o\n")}).events,
              ElementsAre("one", "two", "end"));
}

TEST(RowReader, steps_at_empty_lines_before_any_turn) {
  EXPECT_THAT(read_all({bytes("\n \n")}).events,
              ElementsAre("step", "step", "end"));
}

TEST(RowReader, tells_of_a_signal_and_keeps_what_came_before) {
  EXPECT_THAT(read_all({bytes("one\n\ntwo"), interrupted}).events,
              ElementsAre("one", "quiet", "interrupted"));
}

TEST(RowReader, notes_repaired_and_cut_lines_by_number) {
  const auto outcome = read_all(
      {bytes("fine\na\xFF\n" + std::string(longest_line + 1, 'x') + "\n")});
  EXPECT_THAT(outcome.notes,
              ElementsAre(HasSubstr("input line 2: bytes"),
                          HasSubstr("input line 3: longer than 100000")));
}

} // namespace
} // namespace parlour::tools
