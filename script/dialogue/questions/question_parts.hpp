// QuestionParts: the parts of this folder, each made with those before it. The
// topic engine works with all of them; the effects of scripts are given the few
// that they need.
#pragma once

#include "script/dialogue/questions/asking.hpp"
#include "script/dialogue/questions/clarification.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/next_question.hpp"
#include "script/dialogue/questions/offers.hpp"
#include "script/dialogue/questions/repair_runner.hpp"
#include "script/dialogue/questions/reprompts.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/dialogue/questions/whereabouts.hpp"

namespace parlour::dialogue {

// The conversation makes it, before the topic engine. Each part keeps
// references to those before it, so it stays where it was made.
struct QuestionParts {
  QuestionParts(DialogueContext& context, TopicFrames& frames,
                RunningScript& running, TextEvaluator& texts,
                const Reactions& reactions, OpenQuestion& question,
                OutputManager& output)
      : offers(context, reactions), words(context, frames, texts, output),
        asking(context, output, frames, texts, words, question),
        confirmations(context, frames, running, question, asking),
        whereabouts(context, frames, words, question, confirmations),
        clarification(context, question, words, asking, whereabouts),
        repairs(context, frames, texts, question, whereabouts),
        reprompts(context, running, offers, frames, texts, words, question,
                  asking, clarification, repairs),
        next_question(context, output, frames, words, question, confirmations,
                      reprompts) {}

  Offers offers;
  TopicWords words;
  Asking asking;
  Confirmations confirmations;
  Whereabouts whereabouts;
  Clarification clarification;
  RepairRunner repairs;
  Reprompts reprompts;
  NextQuestion next_question;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(words, asking, clarification); // they keep nothing
    archive(offers, confirmations, whereabouts, repairs, reprompts,
            next_question);
  }
};

} // namespace parlour::dialogue
