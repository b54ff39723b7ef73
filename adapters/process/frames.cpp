#include "adapters/process/frames.hpp"

#include <iterator>

#include "runtime/base/value_bytes.hpp"

namespace parlour::adapters {

namespace {

constexpr std::size_t head = 8;

constexpr std::string_view names[] = {
#define X(name, fields, sentence) #name,
    PARLOUR_FRAMES(X)
#undef X
};

tl::unexpected<Error> rubbish(const std::string& what) {
  return fail(ErrorKind::network, what);
}

Expected<std::optional<Frame>> read_frame(std::string_view bytes) {
  ByteReader reader(bytes);
  const auto kind = reader.below(std::size(names), "a kind of frame");
  auto fields = read_value(reader);
  if (reader.ok() && !reader.at_end())
    reader.fail("more bytes follow the frame");
  if (!reader.ok())
    return rubbish(reader.error().message);
  if (!fields.if_list())
    return rubbish("a frame without fields");
  return Frame{static_cast<FrameKind>(kind), *fields.if_list()};
}

} // namespace

std::string_view name_of(FrameKind kind) {
  return names[static_cast<std::size_t>(kind)];
}

const Value& Frame::at(std::size_t position) const {
  static const Value unknown;
  return position < fields.size() ? fields[position] : unknown;
}

Expected<std::string> frame_bytes(const Frame& frame) {
  ByteWriter body;
  body.byte(static_cast<std::uint8_t>(frame.kind));
  write(body, frame.fields);
  const auto bytes = body.take();
  if (bytes.size() > longest_frame)
    return fail(ErrorKind::limit,
                std::to_string(bytes.size()) +
                    " bytes at once are too many to go from one process to "
                    "another; " +
                    std::to_string(longest_frame) + " can");
  ByteWriter whole;
  whole.fixed(bytes.size());
  return whole.take() + bytes;
}

void FrameReader::add(std::string_view bytes) {
  held_.erase(0, at_);
  at_ = 0;
  held_ += bytes;
}

Expected<std::optional<Frame>> FrameReader::next() {
  const auto left = std::string_view(held_).substr(at_);
  if (left.size() < head)
    return std::nullopt;
  const auto length = ByteReader(left).fixed();
  if (length > longest_frame)
    return rubbish("a frame of " + std::to_string(length) + " bytes");
  if (left.size() - head < length)
    return std::nullopt;
  at_ += head + length;
  return read_frame(left.substr(head, length));
}

} // namespace parlour::adapters
