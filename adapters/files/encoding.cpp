#include "adapters/files/encoding.hpp"

#include <cstdint>

#include <unicode/ustring.h>

namespace parlour::adapters {

bool is_utf8(std::string_view text) {
  auto error = U_ZERO_ERROR;
  std::int32_t needed = 0;
  // A conversion without a target only reports errors.
  u_strFromUTF8(nullptr, 0, &needed, text.data(),
                static_cast<std::int32_t>(text.size()), &error);
  return error != U_INVALID_CHAR_FOUND;
}

} // namespace parlour::adapters
