// OwnWords: what the application's own scripts send to its understanding when
// somebody says something. A handler may change the words before (a table of
// names, say), and the session tells what it expects to hear.
//
//  auto own = OwnWords::start(application, clock);
//  const auto sent = (*own)->say("I am here for Jeff");
//  // sent->text: "I am here for Jeffery"; sent->context: {asked: …, now: …}
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "actors/node/node.hpp"
#include "runtime/base/clock.hpp"
#include "tools/parlour/application/application.hpp"
#include "tools/parlour/application/data_folder.hpp"

namespace parlour::tools {

struct SentWords {
  std::string text;
  Map context;
};

// A node in virtual time with a copy of the databases, which reaches nothing
// outside. For one thread.
class OwnWords {
public:
  // The error says why the application does not start. Its log is not shown.
  static Expected<std::unique_ptr<OwnWords>> start(const Application& of,
                                                   Timestamp clock);
  ~OwnWords();

  // What is said first in a conversation of its own. Nothing if the scripts
  // sent nothing to the understanding.
  std::optional<SentWords> say(const std::string& text);

private:
  explicit OwnWords(DataFolder data);
  void watch(const Inspection& seen);

  DataFolder data_;
  std::optional<SentWords> sent_; // before the node, whose callback sets it
  std::unique_ptr<actors::Node> node_;
  actors::SeatId seat_;
};

} // namespace parlour::tools
