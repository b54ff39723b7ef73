// Events of the Wyoming protocol as bytes: a line of JSON with the event's
// type, then more JSON and a payload, if the line announces their lengths.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "runtime/base/error.hpp"

namespace parlour::adapters::wyoming {

struct Event {
  std::string type;
  nlohmann::json data = nlohmann::json::object();
  std::string payload = {}; // samples
};

// Text that is not UTF-8 is replaced by U+FFFD.
// The payload is sent as it is.
std::string encode(const Event& event);

// The member of this name, or nothing that is of use. Of a text, no more than
// the first `max_text` bytes.
inline constexpr std::size_t max_text = 10'000;
std::string text_of(const nlohmann::json& data, const char* name);
std::int64_t number_of(const nlohmann::json& data, const char* name,
                       std::int64_t otherwise);

// For example `{"type":"audio-chunk","data_length":45,"payload_length":640}`, a
// line end, 45 bytes of JSON, and 640 bytes of samples.
// Cuts a stream into events. It keeps no more than one event of the greatest
// lengths, and refuses greater ones when they are announced.
class EventReader {
public:
  // In bytes. Servers that know hundreds of voices need half of `max_data`.
  static constexpr std::size_t max_header = 1 << 20;
  static constexpr std::size_t max_data = 4 << 20;
  static constexpr std::size_t max_payload = 1 << 20;
  // Lists within lists: each of them costs much more memory than its two bytes.
  static constexpr int max_depth = 32;

  // Adds bytes and returns the events that are complete now. After an error, of
  // kind Network, nothing more can be read.
  Expected<std::vector<Event>> take(std::string_view bytes);
  // Whether an event has begun and not ended.
  // A connection that ends then was cut off.
  bool is_inside() const {
    return !held_.empty() || has_header_;
  }

private:
  // Each takes from `rest`; false: the bytes do not suffice yet.
  Expected<bool> take_one(std::string_view& rest, Event& event);
  Expected<bool> take_header(std::string_view& rest);
  Expected<void> read_header(std::string_view line);

  std::string held_;
  std::size_t searched_ = 0; // of held_, without an end of line
  bool has_header_ = false;
  Event event_; // what is known of the one that has begun
  std::size_t data_length_ = 0;
  std::size_t payload_length_ = 0;
};

} // namespace parlour::adapters::wyoming
