// RequestEffects: what scripts want of components: <post>, <send> to a remote
// agent, and <request>, which waits for the reply.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "script/dialogue/agenda/timers.hpp"
#include "script/dialogue/agenda/wait_outcome.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/questions/whereabouts.hpp"
#include "script/program/host.hpp"

namespace parlour::dialogue {

// Owned by ConversationImplementation. A <request> is a post whose correlation
// is remembered with the wait of its script.
class RequestEffects {
public:
  RequestEffects(DialogueContext& context, Messenger& messenger, Timers& timers,
                 RunningScript& running, const Whereabouts& whereabouts)
      : context_(context), messenger_(messenger), timers_(timers),
        running_(running), whereabouts_(whereabouts) {}

  // All on behalf of that turn, which stays open until the component has
  // answered, or `request-timeout` is over.
  script::Performed post(TurnId turn, const script::Effect& effect);
  script::Performed send(TurnId turn, const script::Effect& effect);
  script::Performed request(TurnId turn, const script::Effect& effect);

  // A reply to a <request>, which is over by that; nothing where none waits for
  // it, or where the event does not end it: then it goes to handlers.
  std::optional<WaitOutcome> reply(const Message& message);
  bool waits_for_answer() const {
    return !requests_.empty();
  }
  // Whether this one is a request whose answer is to come.
  bool awaits(Correlation correlation) const {
    return requests_.contains(correlation);
  }
  // The wait was ended from outside; a reply that still comes goes to handlers.
  void forget(WaitId wait);
  // With another port: the waits for which nobody works any more; those whose
  // answer has come are none of them.
  std::vector<WaitOutcome> lost() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, messenger_, timers_, running_, whereabouts_);
    archive(requests_);
  }

private:
  List params_of(TurnId turn, const script::Effect& effect) const;

  DialogueContext& context_;
  Messenger& messenger_;
  Timers& timers_;
  RunningScript& running_;
  const Whereabouts& whereabouts_;
  std::map<Correlation, WaitId> requests_;
};

} // namespace parlour::dialogue
