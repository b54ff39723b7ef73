// Speaker: a World (conversation_world.hpp) in which the user says words, and
// an NLU component understands some of them.
#pragma once

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {

// The act that the words mean; unknown for all others.
inline Value meaning_of(const std::string& words) {
  if (words == "yes")
    return act("confirm");
  if (words == "no")
    return act("deny");
  if (words == "cancel" || words == "help" || words == "restart")
    return act(words.c_str());
  if (words == "tea" || words == "cocoa")
    return inform("Order", {{"What", slot_value(words, 1)}});
  if (words == "order")
    return act("request", "Order");
  if (words == "delete")
    return act("request", "Delete");
  if (words == "ping")
    return act("request", "Ping");
  return {};
}

// The component answers at once, or if `late`, when the test calls
// answer_late().
class Speaker : public World {
public:
  explicit Speaker(const std::string& script, WorldOptions options = {})
      : World(script, without_pipeline(std::move(options))) {
    components["Grammar"] = {"NLU"};
    answers = [this](const Message& message) {
      if (message.command != "DoNLU" || late)
        return std::vector<Message>{};
      return std::vector<Message>{understood(message)};
    };
    open();
  }

  void hear(const std::string& words) {
    queue(words);
    run();
  }
  // With what a recogniser may have heard instead.
  void hear(const std::string& words, List alternatives) {
    queue(words, std::move(alternatives));
    run();
  }
  void queue(const std::string& words, List alternatives = {}) {
    Message message;
    message.source = "Keyboard";
    message.command = "RecognitionResult";
    message.params = {words, 1};
    if (!alternatives.empty())
      message.params.emplace_back(std::move(alternatives));
    message.session = "s1";
    take(received(std::move(message)));
  }
  void answer_late() {
    take(received(understood(messages.back())));
    run();
  }

  bool late = false;

private:
  static WorldOptions without_pipeline(WorldOptions options) {
    options.open = false;
    options.pipeline = false;
    return options;
  }

  static Message understood(const Message& question) {
    Message event;
    event.source = "Grammar";
    event.session = "s1";
    event.correlation = question.correlation;
    const auto act = meaning_of(question.params[0].text());
    event.command = act.is_unknown() ? "NoResult" : "FrameInfo";
    event.params = {act.is_unknown() ? question.params[0] : act};
    return event;
  }
};

} // namespace parlour::dialogue
