// ComponentNews: what others hear of components: the routing table, the events
// of System, and the answers in place of an instance's own. Lives on the
// supervisor's thread.
#pragma once

#include <string>
#include <vector>

#include "actors/components/deployment.hpp"
#include "actors/components/supervision_parts.hpp"

namespace parlour::actors {

// What goes wrong with a component is told three times, each to its own
// audience: to the senders that wait (an event Failed), to the scripts (an
// event of System), and to the people (the log).
class ComponentNews {
public:
  explicit ComponentNews(const SupervisionParts& parts) : parts_(parts) {}

  // Senders find these from now on; in order of preference.
  void publish_table(const std::vector<DeploymentPointer>& deployments) const;

  // An event of System. One session's own is told to that one, if it listens;
  // else all that do.
  void tell(const char* event, std::vector<Value> params,
            const SessionId& session = {}) const;
  // ComponentUp, with the first role of the component; unknown where it has
  // none.
  void tell_up(const Service& service) const;
  // A component cannot take messages any more, or can again
  // (PluginHost::available). Sessions hear so before the failure answers of
  // `unanswered`.
  void tell_available(const Service& service, bool is_available,
                      std::vector<Message> unanswered = {}) const;
  void log(const std::string& line) const {
    parts_.observer.log(line);
  }

  // Answers those of the messages that wait for an answer, and that somebody
  // still waits for.
  void answer_by_failure(const Service& service,
                         const std::vector<Message>& messages,
                         const std::string& reason) const;
  // The same for all that is in its mailbox.
  void answer_what_waits(const Service& service,
                         const std::string& reason) const;
  // The node stops: nobody waits for answers any more.
  void stop_answering() {
    answers_ = false;
  }

private:
  std::vector<Message> failure_answers(const Service& service,
                                       const std::vector<Message>& messages,
                                       const std::string& reason) const;

  const SupervisionParts& parts_;
  // False from the beginning of the node's end.
  bool answers_ = true;
};

} // namespace parlour::actors
