// Waits for input, for an interrupt, or for the time to pass.
#include "tools/parlour/console/descriptor_source.hpp"

#include <array>
#include <cerrno>

#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"

namespace parlour::tools {

namespace {

using Steady = std::chrono::steady_clock;

Steady::time_point until(std::optional<Milliseconds> patience) {
  return patience ? Steady::now() + *patience : Steady::time_point::max();
}

} // namespace

// An interrupt wins over input that is ready at the same time. A read that a
// signal cut short returns no bytes, and the caller tries again.
Read DescriptorSource::read(std::optional<Milliseconds> patience) {
  pollfd waiting[] = {{interrupt_, POLLIN, 0}, {input_, POLLIN, 0}};
  const auto waited = adapters::wait_until_ready(waiting, until(patience));
  if (waited == adapters::Waited::failed)
    return {Read::Kind::end, {}};
  if (waited == adapters::Waited::late)
    return {Read::Kind::silence, {}};
  if (waiting[0].revents)
    return {Read::Kind::interrupted, {}};
  std::array<char, 65536> buffer;
  const auto size = ::read(input_, buffer.data(), buffer.size());
  if (size > 0)
    return {Read::Kind::bytes,
            std::string(buffer.data(), static_cast<std::size_t>(size))};
  const auto again = size < 0 && (errno == EINTR || errno == EAGAIN);
  return {again ? Read::Kind::bytes : Read::Kind::end, {}};
}

} // namespace parlour::tools
