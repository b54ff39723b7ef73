// Step: one small piece of the dialogue lane's work (engine rules 2, 4, 5): one
// of the structs that steps.def lists. Plain data, so that a session can be
// written out between any two steps; small, as steps are moved often: what is
// large is shared.
#pragma once

#include <concepts>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "script/dialogue/acts/acts.hpp"
#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/agenda/state_stack.hpp"
#include "script/dialogue/agenda/turns.hpp"
#include "script/dialogue/frame/topic_frame.hpp"
#include "script/dialogue/knowledge/knowledge_query.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

using script::StateId;
using OfferId =
    std::uint64_t; // of what reactions may keep; 0: nobody was asked
using ResultPointer = std::shared_ptr<const FrameResult>;

// Where a piece of script stands: what it starts (timers, waits) may end with
// that (engine rule 4.7).
struct Origin {
  VisitId visit = 0;              // of the state that it is of; 0: of none
  CodeId timer = script::no_code; // of the timer that it is of

  template <class Archive>
  void serialize(Archive& archive) {
    archive(visit);
    archive.code(timer);
  }
};

// What a body of script is given, beside where it stands. Kept apart from the
// Body, which stays small: most bodies are given nothing, and the reactions to
// one act share one.
struct BodyInput {
  std::vector<Value> arguments;
  std::shared_ptr<const Message> message; // null: it handles none

  template <class Archive>
  void serialize(Archive& archive) {
    archive(arguments, message);
  }
};

// A piece of script that is to run, with what it stands in.
struct Body {
  CodeId code = script::no_code;
  TopicId topic = script::no_id;
  SlotId slot = script::no_id;
  TurnId turn = 0;
  Origin origin{};
  std::shared_ptr<const BodyInput> input{}; // null: nothing

  template <class Archive>
  void serialize(Archive& archive) {
    archive.code(code);
    archive.slot(topic, slot);
    archive(turn, origin, input);
  }
};

// A timer that rang, as long as anything of its statements is still to come.
// Timers knows it by a weak pointer, the steps RunTimer and Conclude own it: it
// is gone when the timer's item is done, and a repeating timer may ring again.
struct Ring {
  std::string name;
  VisitId visit = 0;
  // The timer was cancelled since it rang: its statements do not run.
  bool stopped = false;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(name, visit, stopped);
  }
};

// A topic's queries on their way: of several, those that come after the one
// that is asked now may still be asked (engine rule 6.3).
struct Lookup {
  KnowledgeQuery query;
  Statement statement;    // that is asked now
  Expected<Value> rows{}; // that it was answered with

  template <class Archive>
  void serialize(Archive& archive) {
    archive(query, statement, rows);
  }
};

namespace steps {
#define FIELD(type, name, initial) type name = initial;
#define STEP(kind, fields, sentence)                                           \
  struct kind {                                                                \
    fields                                                                     \
  };
#include "script/dialogue/agenda/steps.def"
#undef STEP
#undef FIELD

// Tells `visit` each field of a step of that kind, in the table's order.
#define FIELD(type, name, initial) visit(step.name);
#define STEP(kind, fields, sentence)                                           \
  template <class Self, class Visit>                                           \
  requires std::same_as<std::remove_const_t<Self>, kind>                       \
  void visit_fields([[maybe_unused]] Self& step,                               \
                    [[maybe_unused]] Visit&& visit) {                          \
    fields                                                                     \
  }
#include "script/dialogue/agenda/steps.def"
#undef STEP
#undef FIELD

template <class None, class... Kinds>
using OneOf = std::variant<Kinds...>;
} // namespace steps

// A variant of all kinds, in the table's order. The order is a part of the
// saved form: a kind that is put in between others needs another
// conversation_version (saved/archive.hpp).
using Step = steps::OneOf<void
#define STEP(kind, fields, sentence) , steps::kind
#include "script/dialogue/agenda/steps.def"
#undef STEP
                          >;

template <class Kind>
bool is(const Step& step) {
  return std::holds_alternative<Kind>(step);
}

// The user turn that it works for; 0: none. Of a step with a body, the body's.
inline TurnId turn_of(const Step& step) {
  return std::visit(
      [](const auto& kind) -> TurnId {
        if constexpr (requires { kind.turn; })
          return kind.turn;
        else if constexpr (requires { kind.body.turn; })
          return kind.body.turn;
        else
          return 0;
      },
      step);
}

inline std::shared_ptr<const BodyInput>
input_of(std::shared_ptr<const Message> message) {
  return std::make_shared<const BodyInput>(BodyInput{{}, std::move(message)});
}

inline std::shared_ptr<const BodyInput> input_of(std::vector<Value> arguments) {
  return std::make_shared<const BodyInput>(
      BodyInput{std::move(arguments), nullptr});
}

// A step that gives the activation which waits so its outcome. The outcome is
// moved out when the step is taken, so it is given once.
inline steps::ResumeWait outcome_step(WaitId wait, Expected<Value> outcome) {
  return {wait, std::make_shared<Expected<Value>>(std::move(outcome))};
}

} // namespace parlour::dialogue
