// PhraseNLG is the plug-in for the role NLG that makes words of what the engine
// wants to say, from the phrases of application and platform (understanding.md,
// "Phrases"; engine rule 3.4).
//
//  Generate(text)        Speak(text), unchanged
//  Generate(act, data?)  Speak(words). `act` is the map that PhraseEvaluator
//                        takes; `data` is added to it if it has none
//
// If no phrase applies, it answers Speak(""), so that nobody waits for words,
// and NoPhrase(act, topic), so that the missing phrase is noticed.
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Has no state; any number of threads may use it.
class PhraseNLG : public InlinePlugin {
public:
  std::vector<Answer> answers(const Message& message) const override;
};

PluginFactory phrase_nlg_factory();

} // namespace parlour::adapters
