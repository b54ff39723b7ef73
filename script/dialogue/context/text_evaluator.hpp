// TextEvaluator: what the application's texts and conditions come to now. They
// can only compute (docs/writing.md): they read what any script reads, and a
// statement is refused, so nothing that works with topics and questions can be
// called back from here.
#pragma once

#include <string>
#include <vector>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/script_view.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// Used by questions and topics. It runs nothing that waits: text and condition
// are there when the call returns.
class TextEvaluator {
public:
  TextEvaluator(DialogueContext& context, script::Interpreter& interpreter,
                Messenger& messenger, ScriptView& view)
      : context_(context), interpreter_(interpreter), messenger_(messenger),
        view_(view) {}

  // What a text of the topic comes to; empty where there is no code, or where
  // it fails, which is told.
  std::string text_of(CodeId code, TopicId topic);
  // What an expression of the topic comes to; unknown where it fails, which is
  // told.
  Value value_of(CodeId code, TopicId topic);
  // The values of a set as {choices}; a range's bounds as {from, to}, as far as
  // it has them.
  Value choices_of(TopicId topic, SlotId slot);
  // Whether a condition holds. One that fails does not, and is told as
  // Script.Error, for that turn.
  bool holds(CodeId condition, const std::vector<Value>& arguments,
             TopicId topic, TurnId turn);

private:
  Expected<Value> evaluate(CodeId code, const std::vector<Value>& arguments,
                           TopicId topic);

  DialogueContext& context_;
  script::Interpreter& interpreter_;
  Messenger& messenger_;
  ScriptView& view_;
};

} // namespace parlour::dialogue
