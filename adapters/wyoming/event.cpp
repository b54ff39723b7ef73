#include "adapters/wyoming/event.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters::wyoming {

namespace {

using nlohmann::json;

tl::unexpected<Error> broken(std::string what) {
  return fail(ErrorKind::network,
              "the server does not speak the Wyoming protocol: " +
                  std::move(what));
}

// Missing and null are 0.
// A length is refused when it is announced, before memory is taken for it.
Expected<std::size_t> length_of(const json& header, const char* name,
                                std::size_t max) {
  const auto found = header.find(name);
  if (found == header.end() || found->is_null())
    return std::size_t{0};
  if (!found->is_number_unsigned())
    return broken(fmt::format("{} is no length", name));
  const auto length = found->get<std::uint64_t>();
  if (length > max)
    return broken(fmt::format("{} is {}, and at most {} bytes are taken", name,
                              length, max));
  return static_cast<std::size_t>(length);
}

// Discarded if the text is no JSON or nests too deep.
// The library would throw otherwise, and build whatever depth there is.
json parse(std::string_view text, int max_depth) {
  bool is_deep = false;
  auto made = json::parse(
      text,
      [&](int depth, json::parse_event_t, json&) {
        is_deep = is_deep || depth > max_depth;
        return !is_deep;
      },
      false);
  return is_deep ? json(json::value_t::discarded) : made;
}

} // namespace

// The data stand in the header: short ones need no block of their own.
std::string encode(const Event& event) {
  json header = {{"type", event.type}};
  if (!event.data.empty())
    header["data"] = event.data;
  if (!event.payload.empty())
    header["payload_length"] = event.payload.size();
  return header.dump(-1, ' ', false, json::error_handler_t::replace) + '\n' +
         event.payload;
}

// A cut does not go through a character.
std::string text_of(const json& data, const char* name) {
  const auto found = data.find(name);
  if (found == data.end() || !found->is_string())
    return "";
  const auto& text = found->get_ref<const std::string&>();
  auto length = std::min(text.size(), max_text);
  while (length < text.size() && length > 0 &&
         continues_code_point(text[length]))
    --length;
  return text.substr(0, length);
}

std::int64_t number_of(const json& data, const char* name,
                       std::int64_t otherwise) {
  const auto found = data.find(name);
  return found != data.end() && found->is_number_integer()
             ? found->get<std::int64_t>()
             : otherwise;
}

// The bytes that are used up are erased once, not event by event.
Expected<std::vector<Event>> EventReader::take(std::string_view bytes) {
  held_ += bytes;
  std::string_view rest = held_;
  std::vector<Event> events;
  while (true) {
    Event event;
    const auto taken = take_one(rest, event);
    if (!taken)
      return tl::make_unexpected(taken.error());
    if (!*taken)
      break;
    events.push_back(std::move(event));
  }
  held_.erase(0, held_.size() - rest.size());
  return events;
}

// The data behind the header win over those in it.
Expected<bool> EventReader::take_one(std::string_view& rest, Event& event) {
  if (!has_header_)
    if (const auto taken = take_header(rest); !taken || !*taken)
      return taken;
  if (rest.size() < data_length_ + payload_length_)
    return false;
  if (data_length_ > 0) {
    const auto data = parse(rest.substr(0, data_length_), max_depth - 1);
    if (!data.is_object())
      return broken("the data of an event are no JSON object");
    event_.data.update(data);
  }
  event_.payload = rest.substr(data_length_, payload_length_);
  rest.remove_prefix(data_length_ + payload_length_);
  has_header_ = false;
  event = std::exchange(event_, {});
  return true;
}

// What was searched for a line end before is not searched again: a long header
// comes in many pieces.
Expected<bool> EventReader::take_header(std::string_view& rest) {
  const auto end = rest.find('\n', std::min(searched_, rest.size()));
  if (std::min(end, rest.size()) > max_header)
    return broken("a line has no end");
  searched_ = end == std::string_view::npos ? rest.size() : 0;
  if (end == std::string_view::npos)
    return false;
  const auto read = read_header(rest.substr(0, end));
  if (!read)
    return tl::make_unexpected(read.error());
  rest.remove_prefix(end + 1);
  has_header_ = true;
  return true;
}

// Short data may stand in the header itself.
Expected<void> EventReader::read_header(std::string_view line) {
  const auto header = parse(line, max_depth);
  if (!header.is_object() || text_of(header, "type").empty())
    return broken("a line is no JSON object with a type");
  event_ = {text_of(header, "type")};
  if (const auto data = header.find("data");
      data != header.end() && data->is_object())
    event_.data = *data;
  const auto data_length = length_of(header, "data_length", max_data);
  if (!data_length)
    return tl::make_unexpected(data_length.error());
  const auto payload = length_of(header, "payload_length", max_payload);
  if (!payload)
    return tl::make_unexpected(payload.error());
  data_length_ = *data_length;
  payload_length_ = *payload;
  return {};
}

} // namespace parlour::adapters::wyoming
