#include "script/dialogue/saved/writer.hpp"

#include <algorithm>

#include "runtime/base/value_bytes.hpp"
#include "script/dialogue/saved/reactions_of.hpp"

namespace parlour::dialogue {

void Writer::value(const Value& value) {
  parlour::write(bytes_, value);
}

void Writer::reaction(const script::Reaction*& field) {
  const auto all = reactions_of(program());
  const auto place = std::find(all.begin(), all.end(), field) - all.begin();
  bytes_.number(static_cast<std::uint64_t>(place));
}

std::string Writer::finish(const script::Interpreter& interpreter) {
  ByteWriter whole;
  whole.byte(conversation_version);
  whole.text(interpreter.save(activations_));
  whole.add(bytes_);
  return whole.take();
}

} // namespace parlour::dialogue
