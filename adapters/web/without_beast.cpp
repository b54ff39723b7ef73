#include "adapters/web/text_client.hpp"
#include "adapters/web/text_server.hpp"

namespace parlour::adapters::web {

namespace {

constexpr const char* missing =
    "this program was built without Boost.Beast, so it neither serves nor "
    "visits; install libboost-dev and build it again";

} // namespace

Expected<std::unique_ptr<TextServer>> TextServer::start(ServerOptions, Host&,
                                                        Thrown) {
  return fail(ErrorKind::settings, missing);
}

Expected<std::unique_ptr<TextClients>> TextClients::start() {
  return fail(ErrorKind::settings, missing);
}

} // namespace parlour::adapters::web
