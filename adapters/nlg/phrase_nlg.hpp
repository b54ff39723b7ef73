// The plug-in PhraseNLG (role NLG; understanding.md "Phrases"): words for what
// the engine wants to say, from the application's and the platform's phrases.
//
//   Generate(text)        Speak(text), as it is
//   Generate(act, data?)  Speak(words); act is the map of PhraseEvaluator, and
//                         `data` its entry of that name where it has none
//
// Where no phrase applies: Speak("") so that whoever waits goes on, and
// NoPhrase(act, topic) so that it is seen.
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

class PhraseNLG : public InlinePlugin {
public:
  std::vector<Answer> answers(const Message& message) const override;
};

PluginFactory phrase_nlg_factory();

} // namespace parlour::adapters
