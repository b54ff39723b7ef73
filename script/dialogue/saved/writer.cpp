#include "script/dialogue/saved/writer.hpp"

#include <algorithm>

#include "runtime/base/value_bytes.hpp"
#include "script/dialogue/saved/reactions_of.hpp"

namespace parlour::dialogue {

void Writer::value(const Value& value) {
  parlour::write(bytes_, value);
}

// A reaction is told by its number, as addresses differ between processes. Only
// handlers that wait have any, so the search is rare.
void Writer::reaction(const script::Reaction*& field) {
  const auto all = reactions_of(program());
  const auto place = std::find(all.begin(), all.end(), field) - all.begin();
  bytes_.number(static_cast<std::uint64_t>(place));
}

// The parts are written first, as they tell which activations wait; in the
// bytes the interpreter's state comes before them, as a reader needs it first.
std::string Writer::finish(const script::Interpreter& interpreter) {
  ByteWriter whole;
  whole.byte(conversation_version);
  whole.text(interpreter.save(activations_));
  whole.add(bytes_);
  return whole.take();
}

} // namespace parlour::dialogue
