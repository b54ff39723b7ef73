// Any bytes as what a Wyoming server sends, in one piece and byte by byte: both
// must be understood alike. What is understood can be written, and reads the
// same.
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "adapters/wyoming/audio_events.hpp"
#include "adapters/wyoming/event.hpp"

namespace {

using namespace parlour::adapters::wyoming;

bool same(const Event& one, const Event& other) {
  return one.type == other.type && one.data == other.data &&
         one.payload == other.payload;
}

bool same(const std::vector<Event>& one, const std::vector<Event>& other) {
  if (one.size() != other.size())
    return false;
  for (std::size_t i = 0; i < one.size(); ++i)
    if (!same(one[i], other[i]))
      return false;
  return true;
}

// What the components ask an event.
void use(const Event& event) {
  for (const auto* name : {"text", "name"})
    if (trimmed(text_of(event.data, name)).size() > max_text)
      std::abort();
  for (const auto* name : {"rate", "width", "channels", "timestamp"})
    number_of(event.data, name, 0);
  if (samples_of(event.payload).size() > event.payload.size() / 2)
    std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::vector<Event> in_pieces;
  EventReader reader;
  bool is_broken = false;
  for (std::size_t at = 0; at < size && !is_broken; ++at) {
    const auto events = reader.take(bytes.substr(at, 1));
    is_broken = !events;
    if (events)
      in_pieces.insert(in_pieces.end(), events->begin(), events->end());
  }
  // What comes before an error in the same piece is lost with it.
  const auto at_once = EventReader().take(bytes);
  if (at_once.has_value() == is_broken ||
      (at_once && !same(*at_once, in_pieces)))
    std::abort();
  for (const auto& event : in_pieces) {
    use(event);
    const auto again = EventReader().take(encode(event));
    if (!again || !same(*again, {event}))
      std::abort();
  }
  return 0;
}
