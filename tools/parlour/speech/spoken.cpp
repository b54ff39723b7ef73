#include "tools/parlour/speech/spoken.hpp"

namespace parlour::tools {

void Spoken::take(const Message& event) {
  if (event.command == "Finished") {
    finished = true;
  } else if (event.command == "Audio" && !event.params.empty()) {
    const auto sound = adapters::speech_samples(event.params.front());
    if (sound)
      samples.insert(samples.end(), sound->begin(), sound->end());
    else
      trouble = sound.error().message;
  } else if (event.command == "Failed") {
    trouble = event.params.empty() ? "it failed" : event.params.front().text();
  }
}

} // namespace parlour::tools
