#include "adapters/http/message/http_message.hpp"

namespace parlour::adapters::http {

std::string_view name_of(Method method) {
  constexpr std::string_view names[] = {
#define X(name, text, harmless) text,
      PARLOUR_HTTP_METHODS(X)
#undef X
  };
  return names[static_cast<std::size_t>(method)];
}

bool is_idempotent(Method method) {
  constexpr bool harmless_twice[] = {
#define X(name, text, harmless) harmless,
      PARLOUR_HTTP_METHODS(X)
#undef X
  };
  return harmless_twice[static_cast<std::size_t>(method)];
}

} // namespace parlour::adapters::http
