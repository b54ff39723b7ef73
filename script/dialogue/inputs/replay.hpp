// Replay repeats a session from what was noted: the inputs in their order, each
// with the answers that it met (engine rule 7.2). It is the session again, word
// by word, or says at which input it is another one.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "script/dialogue/inputs/replay_port.hpp"
#include "script/dialogue/inputs/session_input.hpp"

namespace parlour::dialogue {

// Both as bytes (saved/archive.hpp), of a program.
std::string to_bytes(const script::Program& program, const TimedInput& input);
std::string to_bytes(const script::Program& program,
                     const PortAnswers& answers);
// Errors of kind File, where the bytes are damaged or of another program.
Expected<TimedInput> read_input(std::shared_ptr<const script::Program> program,
                                std::string_view bytes);
Expected<PortAnswers>
read_answers(std::shared_ptr<const script::Program> program,
             std::string_view bytes);

// Owns the conversation that is repeated and the port which stands for its
// surroundings. For `parlour replay`, and for a session after a crash. Not
// thread-safe.
class Replay {
public:
  // A session that has not begun; its first input is Begun.
  Replay(std::shared_ptr<const script::Program> program,
         Conversation::Options options);
  // One that goes on from the bytes of Conversation::save().
  static Expected<std::unique_ptr<Replay>>
  from(std::shared_ptr<const script::Program> program,
       Conversation::Options options, std::string_view bytes);

  // An error, of kind File, says how this differs from what was noted; the
  // session has taken the input all the same.
  Expected<void> take(TimedInput input, PortAnswers answers);
  // An input whose answers nobody has noted: `live` is asked. For who goes on
  // with a repeated session by hand. Whatever else the session wants goes
  // nowhere.
  void take(TimedInput input, Port& live);

  const Conversation& conversation() const {
    return *conversation_;
  }
  // To hear what is said and posted, and to watch.
  ReplayPort& port() {
    return port_;
  }

private:
  void take(TimedInput input);

  ReplayPort port_;
  std::unique_ptr<Conversation> conversation_;
};

} // namespace parlour::dialogue
