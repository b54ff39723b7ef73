// What takes the place of curl_transfers.cpp where libcurl is missing: rules
// can be checked and tried with their samples, but no service can be asked.
#include "adapters/http/transfer/transfers.hpp"

namespace parlour::adapters::http {

Expected<std::unique_ptr<Transfers>> curl_transfers(Loop&, TransferOptions) {
  return fail(ErrorKind::settings,
              "this program was built without libcurl, so it can ask no "
              "service; install libcurl4-openssl-dev and build it again, or "
              "say <option name=\"samples\" value=\"true\"/>");
}

} // namespace parlour::adapters::http
