// Classifier: which topic an act is about where the understanding did not say,
// or named one that does not take part (engine rule 5, "Acts"; paper Fig. 3).
// Pure.
#pragma once

#include <span>
#include <vector>

#include "script/dialogue/acts/acts.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

using script::TopicId;

struct ClassifierContext {
  TopicId asked = script::no_id; // the topic whose slot is being asked
  script::SlotId asked_slot = script::no_id;
  TopicId current = script::no_id;
  TopicId resting = script::no_id;
  std::span<const TopicId> unfinished{};
  std::vector<TopicId> unregistered{}; // never chosen
};

// A registered topic that the act names stands. Else the topic that has most
// of the act's slots; of equals the one being asked, then the current, the
// resting, an unfinished one, then any in file order. Without slots: the topic
// being asked; an elliptical turn also the resting or current one. no_id where
// nothing fits.
TopicId classify(const script::Program& program, const Act& act,
                 const ClassifierContext& context);

// What is said in passing ("and on the first?") right after an enquiry is
// about that one, where it may be: the act becomes that reading of it.
void prefer_resting(const script::Program& program, Act& act,
                    const ClassifierContext& context);

// The topics to clarify between, best first: the act's and those of its
// alternatives that are within 0.1 of the best; empty where only one is.
std::vector<TopicId> clarify(const script::Program& program, const Act& act,
                             const ClassifierContext& context);

} // namespace parlour::dialogue
