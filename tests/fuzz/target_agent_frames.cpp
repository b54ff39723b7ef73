// Any frames of a ZeroMQ message, cut from the bytes at each 0. What is
// accepted must be written as frames that read the same.
#include <algorithm>
#include <cstdlib>

#include "adapters/agents/wire/multipart.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace parlour::adapters::agents;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::vector<std::string_view> frames = {protocol_frame};
  for (std::size_t at = 0; at <= bytes.size();) {
    const auto end = std::min(bytes.find('\0', at), bytes.size());
    frames.push_back(bytes.substr(at, end - at));
    at = end + 1;
  }
  const auto message = read_frames(frames);
  if (!message)
    return 0;
  const auto written = frames_of(*message);
  if (!written)
    std::abort();
  const auto again = read_frames({written->begin(), written->end()});
  if (!again || *again != *message)
    std::abort();
  return 0;
}
