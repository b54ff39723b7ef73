// Any bytes are a value in its one form, or an error.
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
