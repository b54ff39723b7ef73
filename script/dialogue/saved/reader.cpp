#include "script/dialogue/saved/reader.hpp"

#include <string>

#include "runtime/base/value_bytes.hpp"
#include "script/dialogue/saved/reactions_of.hpp"

namespace parlour::dialogue {

namespace {

// Parts within parts: a question before a question, an act of that. Made-up
// bytes could nest them until the stack is full; what is written by a
// conversation is far from that.
constexpr int deepest = 1000;

} // namespace

Reader::Reader(std::shared_ptr<const script::Program> program,
               std::string_view bytes)
    : Archive(*program), program_(std::move(program)), bytes_(bytes) {}

// The identity of the program is checked by the interpreter's state. The
// activations come with it, in the order in which the parts ask for them.
void Reader::begin(script::Interpreter& interpreter) {
  const auto version = bytes_.byte();
  if (version != conversation_version)
    bytes_.fail("this conversation is of version " + std::to_string(version) +
                ", but only " + std::to_string(conversation_version) +
                " can be read here; start the session anew");
  const auto state = bytes_.block();
  if (!ok())
    return;
  auto restored = script::Interpreter::restore(program_, state);
  if (!restored)
    return bytes_.fail(restored.error().message);
  interpreter = std::move(restored->interpreter);
  activations_ = std::move(restored->activations);
}

void Reader::activation(std::unique_ptr<script::Activation>& field) {
  if (next_ == activations_.size())
    bytes_.fail("there are more waits than activations");
  else
    field = std::move(activations_[next_++]);
}

void Reader::reaction(const script::Reaction*& field) {
  const auto all = reactions_of(*program_);
  const auto place = bytes_.below(all.size(), "reaction");
  field = ok() ? all[place] : nullptr;
}

// An activation without a wait would never go on.
Expected<void> Reader::finish() {
  check(next_ == activations_.size(), "an activation waits for nothing");
  if (ok() && !bytes_.at_end())
    bytes_.fail("more bytes follow the conversation");
  if (!ok())
    return tl::make_unexpected(bytes_.error());
  return {};
}

void Reader::value(Value& field) {
  field = read_value(bytes_);
}

bool Reader::enter() {
  if (depth_ == deepest)
    bytes_.fail("parts are nested too deeply");
  if (!ok())
    return false;
  ++depth_;
  return true;
}

} // namespace parlour::dialogue
