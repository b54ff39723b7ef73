#include "tools/parlour/console/descriptor_source.hpp"

#include <array>
#include <cerrno>

#include <poll.h>
#include <unistd.h>

namespace parlour::tools {

Read DescriptorSource::read(std::optional<Milliseconds> patience) {
  pollfd waiting[] = {{interrupt_, POLLIN, 0}, {input_, POLLIN, 0}};
  const auto limit = patience ? static_cast<int>(patience->count()) : -1;
  const auto ready = poll(waiting, 2, limit);
  if (ready < 0 && errno != EINTR)
    return {Read::Kind::end, {}};
  if (ready > 0 && waiting[0].revents)
    return {Read::Kind::interrupted, {}};
  if (ready <= 0)
    return {ready == 0 ? Read::Kind::silence : Read::Kind::bytes, {}};
  std::array<char, 65536> buffer;
  const auto size = ::read(input_, buffer.data(), buffer.size());
  if (size > 0)
    return {Read::Kind::bytes,
            std::string(buffer.data(), static_cast<std::size_t>(size))};
  const auto again = size < 0 && (errno == EINTR || errno == EAGAIN);
  return {again ? Read::Kind::bytes : Read::Kind::end, {}};
}

} // namespace parlour::tools
