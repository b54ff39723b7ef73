// Transfers sends requests, each once, and tells what came back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "adapters/http/message/http_message.hpp"
#include "adapters/loop/loop.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::http {

struct TransferOptions {
  // How long a connection may take to come about.
  Milliseconds connect_timeout{3'000};
  // The largest body of an answer, in bytes, after decompression.
  std::size_t max_answer = 1 << 20;
  // Certificates in PEM that are trusted instead of the machine's; empty: those
  // of the machine.
  std::filesystem::path authority = {};
  // A proxy; empty: none.
  std::string proxy = {};
};

// Used on the loop's thread only.
// An interface, so that HttpClient is tested without a network.
class Transfers {
public:
  using Id = std::uint64_t;
  // Called once, on the loop's thread and never within start(). It may start
  // and cancel transfers.
  using Done = std::function<void(TryOutcome)>;

  virtual ~Transfers() = default;

  // `time`: how long the transfer may take. A redirect is an answer.
  virtual Id start(const HttpRequest& request, Milliseconds time,
                   Done done) = 0;
  // Ends it; `done` is not called. Does nothing if it is over.
  virtual void cancel(Id id) = 0;
};

// Over libcurl. The error says that this build has no libcurl, or that it
// cannot begin. The loop outlives the result.
Expected<std::unique_ptr<Transfers>> curl_transfers(Loop& loop,
                                                    TransferOptions options);

} // namespace parlour::adapters::http
