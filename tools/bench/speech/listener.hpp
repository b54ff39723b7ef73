// Listener: says one line to the chain from detector to understanding, without
// a conversation.
#pragma once

#include <memory>
#include <string>

#include "adapters/audio/mixing.hpp"
#include "adapters/nlu/understand/nlu_engine.hpp"
#include "tools/parlour/speech/ears.hpp"

namespace parlour::tools {

struct HeardLine {
  std::string text;     // of all its turns; empty: nothing was recognised
  bool rejected = true; // by the recogniser
  List acts;            // of its first turn that was understood
};

// For one thread.
class Listener {
public:
  // The application has a voice seat, must outlive it, and its understanding is
  // GrammarNLU. `told`: the recogniser knows what is said in dialogues/.
  static Expected<std::unique_ptr<Listener>> start(const Application& spoken,
                                                   bool told);

  // The line in a noise that is repeated; it may be empty.
  Expected<HeardLine> hear(const adapters::Sound& line,
                           const adapters::Sound& noise = {});
  // The acts of a text.
  List understand(const std::string& text, const List& alternatives = {}) const;

private:
  Listener(Application application, adapters::nlu::NluEngine engine,
           Map context);

  const Application application_;
  const adapters::nlu::NluEngine engine_;
  const Map context_;
  std::unique_ptr<Ears> ears_;
};

} // namespace parlour::tools
