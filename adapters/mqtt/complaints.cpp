#include "adapters/mqtt/complaints.hpp"

namespace parlour::adapters::mqtt {

// "… is no state of 'door' (and 41 more)": what was not written is counted with
// the next line.
std::optional<std::string>
Complaints::note(Complaint complaint, const std::string& text,
                 std::chrono::steady_clock::time_point now) {
  auto& kind = kinds_.at(static_cast<std::size_t>(complaint));
  ++kind.count;
  if (kind.written > 0 && now - kind.at < one_line_in)
    return {};
  const auto more = kind.count - kind.written - 1;
  kind.written = kind.count;
  kind.at = now;
  return more == 0 ? text : text + " (and " + std::to_string(more) + " more)";
}

std::uint64_t Complaints::count(Complaint kind) const {
  return kinds_.at(static_cast<std::size_t>(kind)).count;
}

} // namespace parlour::adapters::mqtt
