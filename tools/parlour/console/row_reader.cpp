// Rows of turns from bytes: lines_ splits the bytes, take() groups the lines.
#include "tools/parlour/console/row_reader.hpp"

#include <utility>

namespace parlour::tools {

RowReader::RowReader(ByteSource& source, Note note)
    : source_(source), note_(std::move(note)) {}

RowEvent RowReader::next() {
  while (events_.empty())
    read_more();
  auto event = std::move(events_.front());
  events_.pop_front();
  return event;
}

// Inside of a row, a pause of row_pause ends the row. Between rows there is no
// limit.
void RowReader::read_more() {
  auto read =
      source_.read(row_.empty() ? std::nullopt : std::optional(row_pause));
  switch (read.kind) {
  case Read::Kind::bytes: {
    std::string_view bytes = read.bytes;
    while (auto line = lines_.take(bytes))
      take(std::move(*line));
    break;
  }
  case Read::Kind::silence:
    return end_row();
  case Read::Kind::end:
    return read_rest();
  case Read::Kind::interrupted:
    events_.push_back({RowEvent::Kind::interrupted, {}, false});
  }
}

// An empty line ends the row. Directly after a turn it means "wait for the
// answer", otherwise "let time pass".
void RowReader::take(Line line) {
  ++number_;
  const auto place = "input line " + std::to_string(number_) + ": ";
  if (line.repaired)
    note_(place + "bytes that are no UTF-8 text are read as U+FFFD");
  if (line.cut)
    note_(place + "longer than " + std::to_string(longest_line) +
          " characters; the rest is left out");
  if (!is_blank(line.text)) {
    row_bytes_ += line.text.size();
    row_.push_back(std::move(line.text));
    after_turn_ = true;
    if (row_.size() >= longest_row || row_bytes_ >= longest_row_bytes)
      end_part();
    return;
  }
  end_row();
  events_.push_back(
      {after_turn_ ? RowEvent::Kind::quiet : RowEvent::Kind::step, {}, false});
  after_turn_ = false;
}

// Delivers the row, if it has turns. An empty row is no event.
void RowReader::end_row() {
  if (!row_.empty())
    events_.push_back({RowEvent::Kind::turns, std::exchange(row_, {}), false});
  row_bytes_ = 0;
}

// Reported once; a stream without pauses would report it all the time.
void RowReader::end_part() {
  if (!std::exchange(told_of_parts_, true))
    note_("input line " + std::to_string(number_) +
          ": too many turns come without a pause; they are taken in parts");
  end_row();
  events_.back().is_part = true;
}

// The last line may lack its line end.
void RowReader::read_rest() {
  if (auto line = lines_.finish(); line && !is_blank(line->text))
    take(std::move(*line));
  end_row();
  events_.push_back({RowEvent::Kind::end, {}, false});
}

} // namespace parlour::tools
