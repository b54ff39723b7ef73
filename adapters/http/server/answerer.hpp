// Answerer: who answers the requests that a RequestServer hears.
#pragma once

#include <functional>

#include "adapters/http/server/received_request.hpp"
#include "adapters/http/server/reply.hpp"

namespace parlour::adapters::http {

// Called on the server's thread; they must not block for long. Where one of
// them throws, there is no answer: the connection stays until its patience
// ends.
struct Answerer {
  // A complete request.
  std::function<Reply(const ReceivedRequest&)> answer;
  // What is none, or is too large: 400, 413 or 431. Null: the status alone is
  // the answer.
  std::function<Reply(int status)> refuse = {};
};

} // namespace parlour::adapters::http
