#include "script/dialogue/inputs/session_record.hpp"

#include <type_traits>
#include <utility>

#include "runtime/base/bytes.hpp"

namespace parlour::dialogue {

namespace {

// Writes one field; Reading, its counterpart, reads it.
struct Writing {
  ByteWriter& bytes;

  void operator()(std::uint64_t number) const {
    bytes.fixed(number);
  }
  void operator()(const std::string& text) const {
    bytes.text(text);
  }
  void operator()(bool flag) const {
    bytes.byte(flag);
  }
  void operator()(const std::vector<TurnLog::Said>& all) const {
    bytes.fixed(all.size());
    for (const auto& said : all) {
      bytes.fixed(said.turn);
      bytes.fixed(said.output);
      bytes.byte(static_cast<std::uint8_t>(said.act));
      bytes.text(said.text);
    }
  }
};

struct Reading {
  ByteReader& bytes;

  void operator()(std::uint64_t& number) const {
    number = bytes.fixed();
  }
  void operator()(std::string& text) const {
    text = bytes.block();
  }
  void operator()(bool& flag) const {
    flag = bytes.byte() != 0;
  }
  void operator()(std::vector<TurnLog::Said>& all) const {
    const auto count = bytes.fixed();
    for (std::uint64_t i = 0; i < count && bytes.ok(); ++i) {
      auto& said = all.emplace_back();
      said.turn = bytes.fixed();
      said.output = bytes.fixed();
      const auto act = bytes.byte();
      if (act > static_cast<std::uint8_t>(OutputAct::chat))
        return bytes.fail("an output of an unknown kind");
      said.act = static_cast<OutputAct>(act);
      said.text = bytes.text();
    }
  }
};

// Writes and reads, so that both have one form: the fields of each kind, in the
// order that session_record.hpp says.
template <class Visit, class What>
void each(Visit visit, What& it) {
  using Kind = std::remove_const_t<What>;
  if constexpr (std::is_same_v<Kind, SessionOpened>) {
    visit(it.program);
    visit(it.seed);
    visit(it.strict);
    visit(it.seat);
  } else if constexpr (std::is_same_v<Kind, InputTaken>) {
    visit(it.input);
    visit(it.answers);
  } else if constexpr (std::is_same_v<Kind, StateKept>) {
    each(visit, it.opened);
    visit(it.inputs);
    visit(it.state);
    visit(it.turns.taken);
    visit(it.turns.done);
    visit(it.turns.said);
  } else if constexpr (std::is_same_v<Kind, EffectsDone>) {
    visit(it.inputs);
  }
}

using What = decltype(SessionRecord::what);

// The alternative of that number; false where there is none.
template <std::size_t... Kinds>
bool choose(What& what, std::size_t kind, std::index_sequence<Kinds...>) {
  return (... || (Kinds == kind && (what.emplace<Kinds>(), true)));
}

} // namespace

std::string to_bytes(const SessionRecord& record) {
  ByteWriter bytes;
  bytes.byte(session_record_version);
  bytes.byte(static_cast<std::uint8_t>(record.what.index()));
  bytes.text(record.session);
  std::visit([&](const auto& it) { each(Writing{bytes}, it); }, record.what);
  return bytes.take();
}

// After the first failure the reader gives zeros, so it goes on to its end, and
// the error is that first one.
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
  if (choose(record.what, kind,
             std::make_index_sequence<std::variant_size_v<What>>()))
    std::visit([&](auto& it) { each(Reading{reader}, it); }, record.what);
  else
    reader.fail("a record of an unknown kind");
  if (reader.ok() && !reader.at_end())
    reader.fail("more bytes follow the record");
  if (!reader.ok())
    return tl::make_unexpected(reader.error());
  return record;
}

} // namespace parlour::dialogue
