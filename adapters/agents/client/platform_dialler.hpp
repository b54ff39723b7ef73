// PlatformDialler opens an agent's connections to the platform, by any
// transport.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "adapters/agents/delivery/peer_connection.hpp"
#include "adapters/agents/zeromq/key_pair.hpp"
#include "adapters/loop/loop.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::agents {

struct PlatformAddress {
  std::string host;
  std::string port;
  // Lines under TLS.
  bool is_encrypted = false;
  // A file in PEM with the certificate that the platform's is checked against;
  // empty: those that the system trusts.
  std::string authority = {};
  // By ZeroMQ and not by lines.
  bool is_zeromq = false;
  // For CURVE: the agent's own keys, and the platform's public key. If they are
  // empty, nothing is encrypted.
  KeyPair own_keys = {};
  std::string platform_key = {};
};

// Used on the loop's thread.
class PlatformDialler {
public:
  using Connected = Expected<std::shared_ptr<PeerConnection>>;
  using Done = std::function<void(Connected connection)>;

  // `loop` must outlive it. The error, of kind Settings, names a file that
  // cannot be read.
  static Expected<std::unique_ptr<PlatformDialler>>
  make(Loop& loop, PlatformAddress address);
  virtual ~PlatformDialler() = default;

  // Calls `done` once, perhaps within this call, unless it is destroyed before.
  // ZeroMQ does not tell whether anybody is there. One call at a time.
  virtual void dial(ConnectionId id, PeerConnection::Owner& owner,
                    Done done) = 0;
  // What is being dialled fails soon.
  virtual void cancel() = 0;
};

} // namespace parlour::adapters::agents
