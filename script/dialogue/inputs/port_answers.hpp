// PortAnswers: what a conversation was told at once by its port while it dealt
// with one input, and a hash of what it wanted. With it the input can be dealt
// with again where nobody else is there, and the first step that differs shows.
// For example, "ynP" says: the first role that was asked for is there, the
// second is not, and a message was posted that an inline component answered;
// the answer is the first entry of `posted`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"

namespace parlour::dialogue {

// Plain data, one for each input. A RecordingPort fills it, the journal keeps
// it as bytes, a ReplayPort gives it back.
struct PortAnswers {
  // One letter each, in the order of the questions:
  //   p  post, which nobody answered     P  post; the next of `posted`
  //   y  reachable, is_source: yes       n  no
  //   0  reply_to_request: none          1  answer      2  refusal
  //   s  send_socket: sent               f  not sent; the next of `failures`
  std::string letters;
  // Of each `P`: what inline components answered.
  std::vector<std::vector<Message>> posted;
  // Of each `f`.
  std::vector<Error> failures;
  std::uint64_t wishes = 0; // a hash of all that was wanted, in order

  template <class Archive>
  void serialize(Archive& archive) {
    archive(letters, posted, failures, wishes);
  }
};

} // namespace parlour::dialogue
