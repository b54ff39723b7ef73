// Which pages may talk to the server: a browser names the origin of the page
// that connects, and would let any page of the web connect to this machine.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::web {

// Those of this machine, by whatever port, and those in the list.
// `origin` is the header's value, "https://kiosk.example:8443". What is no
// browser sends none, and is not asked.
bool is_allowed_origin(std::string_view origin,
                       const std::vector<std::string>& allowed);

} // namespace parlour::adapters::web
