#include "script/dialogue/inputs/session_record.hpp"

#include "runtime/base/bytes.hpp"

namespace parlour::dialogue {

std::string to_bytes(const SessionRecord& record) {
  ByteWriter bytes;
  bytes.byte(session_record_version);
  bytes.byte(static_cast<std::uint8_t>(record.what.index()));
  bytes.text(record.session);
  if (const auto* opened = std::get_if<SessionOpened>(&record.what)) {
    bytes.fixed(opened->program);
    bytes.fixed(opened->seed);
  } else if (const auto* taken = std::get_if<InputTaken>(&record.what)) {
    bytes.text(taken->input);
    bytes.text(taken->answers);
  }
  return bytes.take();
}

Expected<SessionRecord> read_record(std::string_view bytes) {
  ByteReader reader(bytes);
  if (const auto version = reader.byte();
      reader.ok() && version != session_record_version)
    reader.fail("a record of version " + std::to_string(version) +
                ", but only " + std::to_string(session_record_version) +
                " can be read here");
  const auto kind = reader.byte();
  SessionRecord record;
  record.session = reader.text();
  if (kind == 0) {
    const auto program = reader.fixed();
    record.what = SessionOpened{program, reader.fixed()};
  } else if (kind == 1) {
    std::string input(reader.block());
    record.what = InputTaken{std::move(input), std::string(reader.block())};
  } else {
    reader.fail("a record of an unknown kind");
  }
  if (reader.ok() && !reader.at_end())
    reader.fail("more bytes follow the record");
  if (!reader.ok())
    return tl::make_unexpected(reader.error());
  return record;
}

} // namespace parlour::dialogue
