// Reads a value from any bytes. If they are accepted, writing the value must
// give the same bytes.
#include <cstdlib>

#include "runtime/base/value_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto value = parlour::value_from_bytes(bytes);
  if (value && parlour::to_bytes(*value) != bytes)
    std::abort();
  return 0;
}
