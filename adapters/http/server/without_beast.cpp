// What takes the place of beast_parser.cpp where Boost is missing: services can
// be asked, but nobody can ask or report to us.
#include "adapters/http/server/request_parser.hpp"

namespace parlour::adapters::http {

std::unique_ptr<RequestParser> make_request_parser(std::size_t) {
  return nullptr;
}

} // namespace parlour::adapters::http
