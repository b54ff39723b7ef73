// Offers: acts and the like, offered to the reactions that listen to source
// Dialogue before the topic engine deals with them; <consume/> keeps one.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/reactions.hpp"

namespace parlour::dialogue {

inline const std::string dialogue_source = "Dialogue";

// Engine rule 2.8. The reactions run as steps of the lane, and may wait; only
// then it is known whether one of them has consumed the act. So each offer has
// a number: it is the number of the message that the reactions see, <consume/>
// notes it, and the step behind them asks for it.
class Offers {
public:
  Offers(DialogueContext& context, const Reactions& reactions)
      : context_(context), reactions_(reactions) {}

  // The number of what is offered next. Never 0, which stands for what nobody
  // was offered.
  OfferId next_offer();
  // To the reactions that listen to source Dialogue; `otherwise` follows unless
  // one of them keeps it for itself. A reaction of a state with `capture`
  // always does, so `otherwise` is dropped there at once (engine rule 4.4).
  void offer(std::string command, Value parameter, OfferId number,
             Step otherwise);
  // Whether there is any; of the active state, or at all.
  bool listens(const std::string& command) const {
    return reactions_.listens(dialogue_source, command);
  }
  bool state_listens(std::string_view command) const {
    return reactions_.state_listens(dialogue_source, command);
  }
  // Who offered it asks once: it is forgotten here.
  bool was_consumed(OfferId number);

  // <consume/> in a reaction to what was offered with this number, also after
  // it waited.
  void consume(OfferId number) {
    consumed_.insert(number);
  }
  bool consumed(OfferId number) const {
    return consumed_.contains(number);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, reactions_);
    archive(offered_, consumed_);
  }

private:
  DialogueContext& context_;
  const Reactions& reactions_;
  std::uint64_t offered_ = 0;  // counted
  std::set<OfferId> consumed_; // of these
};

} // namespace parlour::dialogue
