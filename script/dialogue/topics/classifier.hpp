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

// Where the conversation is, as far as it tells what is spoken about. no_id:
// there is no such topic. `unfinished` refers to somebody else's list.
struct ClassifierContext {
  TopicId asked = script::no_id; // the topic whose slot is being asked
  script::SlotId asked_slot = script::no_id;
  TopicId current = script::no_id;
  TopicId resting = script::no_id;
  std::span<const TopicId> unfinished{};
  TopicId completed = script::no_id;   // the latest, if nothing came after it
  std::vector<TopicId> unregistered{}; // never chosen
};

// A registered topic that the act names stands. Else the topic that has most of
// the act's slots; of equals the one being asked, then the current, the
// resting, an unfinished one, the one that was completed last, then any in file
// order. Without slots: the topic being asked; an elliptical turn also the
// resting or current one. no_id where nothing fits. "At three." -> the topic
// that asks, if it has a slot for a time.
TopicId classify(const script::Program& program, const Act& act,
                 const ClassifierContext& context);

// What is said in passing ("and on the first?") right after an enquiry is about
// that one, where it may be: the act becomes that reading of it (engine rule
// 5.3, step 4). The act keeps its own words; its alternatives are gone.
void prefer_resting(const script::Program& program, Act& act,
                    const ClassifierContext& context);

// A reading that has only values which nobody knows does not stand beside one
// within 0.1 that has others: "when is it coming back?" asks for no book called
// "coming" (engine rule 5.3, step 6).
void prefer_known(Act& act);

// The topics to clarify between, best first: the act's and those of its
// alternatives that are within 0.1 of the best; empty where only one is, where
// the act has no confidence to compare with, and for an elliptical act about
// the enquiry that rests.
std::vector<TopicId> clarify(const script::Program& program, const Act& act,
                             const ClassifierContext& context);

} // namespace parlour::dialogue
