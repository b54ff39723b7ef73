#include "adapters/agents/zeromq/key_pair.hpp"

#include <array>

#include <zmq.h>

namespace parlour::adapters::agents {

Expected<KeyPair> new_key_pair() {
  // The C function adds a zero byte.
  std::array<char, key_characters + 1> public_key{};
  std::array<char, key_characters + 1> secret_key{};
  if (zmq_curve_keypair(public_key.data(), secret_key.data()) != 0)
    return fail(ErrorKind::settings,
                "this libzmq was built without CURVE encryption");
  return KeyPair{public_key.data(), secret_key.data()};
}

} // namespace parlour::adapters::agents
