// A world that notes the inputs of its conversation, and what the conversation
// was told at each by its port.
#pragma once

#include <utility>
#include <vector>

#include "script/dialogue/inputs/recording_port.hpp"
#include "script/dialogue/inputs/replay.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {

struct NotedWorld : World {
  std::vector<TimedInput> inputs;
  std::vector<PortAnswers> answers;

  // Begins in the state S.
  explicit NotedWorld(const char* application) : World(application, options()) {
    repeats = false; // the port is another one
    conversation = std::make_unique<Conversation>(
        program, ConversationOptions{"s1", 1, nullptr}, port_);
    World::open();
  }
  void take(SessionInput input) override {
    inputs.push_back({now, input});
    World::take(std::move(input));
    answers.push_back(port_.take_answers());
  }

private:
  static WorldOptions options() {
    WorldOptions options;
    options.start = "S";
    options.open = false;
    return options;
  }
  // It is not put aside: what is noted here is of one port.
  void before_move() override {}

  RecordingPort port_{*this};
};

} // namespace parlour::dialogue
