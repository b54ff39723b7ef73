#include "runtime/message/inspection.hpp"

namespace parlour {

std::string concern_of(const Inspection& seen) {
  if (seen.session.empty())
    return "";
  auto text = "  (session " + seen.session;
  if (seen.turn != 0)
    text += ", turn " + std::to_string(seen.turn);
  return text + ")";
}

} // namespace parlour
