#include "adapters/process/ipc_message.hpp"

#include <iterator>

#include "runtime/base/value_bytes.hpp"

namespace parlour::adapters {

namespace {

// The bytes of the length.
constexpr std::size_t head = 8;

constexpr std::string_view names[] = {
#define X(name, fields, sentence) #name,
    PARLOUR_IPC_MESSAGES(X)
#undef X
};

tl::unexpected<Error> rubbish(const std::string& what) {
  return fail(ErrorKind::network, what);
}

// Reads one message without its length. All bytes must be used.
Expected<std::optional<IpcMessage>> read_message(std::string_view bytes) {
  ByteReader reader(bytes);
  const auto kind = reader.below(std::size(names), "a kind of message");
  auto fields = read_value(reader);
  if (reader.ok() && !reader.at_end())
    reader.fail("more bytes follow the message");
  if (!reader.ok())
    return rubbish(reader.error().message);
  if (!fields.if_list())
    return rubbish("a message without fields");
  return IpcMessage{static_cast<IpcKind>(kind), *fields.if_list()};
}

} // namespace

std::string_view name_of(IpcKind kind) {
  return names[static_cast<std::size_t>(kind)];
}

const Value& IpcMessage::at(std::size_t position) const {
  static const Value unknown;
  return position < fields.size() ? fields[position] : unknown;
}

// The length is known only when the body has been written.
Expected<std::string> ipc_bytes(const IpcMessage& message) {
  ByteWriter body;
  body.byte(static_cast<std::uint8_t>(message.kind));
  write(body, message.fields);
  const auto bytes = body.take();
  if (bytes.size() > longest_ipc_message)
    return fail(ErrorKind::limit,
                std::to_string(bytes.size()) +
                    " bytes at once are too many to go from one process to "
                    "another; " +
                    std::to_string(longest_ipc_message) + " can");
  ByteWriter whole;
  whole.fixed(bytes.size());
  return whole.take() + bytes;
}

void IpcReader::add(std::string_view bytes) {
  // Messages that next() returned are removed here, once for all of them.
  held_.erase(0, at_);
  at_ = 0;
  held_ += bytes;
}

Expected<std::optional<IpcMessage>> IpcReader::next() {
  const auto left = std::string_view(held_).substr(at_);
  if (left.size() < head)
    return std::nullopt;
  // The length is checked before any memory depends on it.
  const auto length = ByteReader(left).fixed();
  if (length > longest_ipc_message)
    return rubbish("a message of " + std::to_string(length) + " bytes");
  if (left.size() - head < length)
    return std::nullopt;
  at_ += head + length;
  return read_message(left.substr(head, length));
}

} // namespace parlour::adapters
