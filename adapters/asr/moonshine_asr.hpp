// MoonshineASR is a plug-in for the role ASR: a neural recogniser of English
// that knows any words, prefers those of the application, and works offline. It
// runs in a program of its own (tools/agents/moonshine), which this plug-in
// starts, watches and ends.
//
//  DoRecognition(audio)
//      The next piece of the session's turn. Partial(text, revision, ends?) now
//      and then; `ends` is whether a sentence of the grammars may end there.
//  Finish()
//      RecognitionResult(text, confidence, alternatives, words) or
//      Rejected(reason). The confidence is that of the least certain word;
//      alternatives and words are maps with `text` and `confidence`.
//  Cancel()
//      Drops the session's turn; a Finish that waits is answered by Rejected.
//
//  SetGrammar(names)
//      Prefers only the words of these grammars, rules, slots or forms in the
//      session's turns from the next one on, beside what is said in any
//      conversation; an empty list: those of the whole application.
//  SetValues(column, values)
//      Prefers the column's values from the next turn on.
//
// It starts at once; what is said while the network is being loaded waits. The
// first 30 s of a turn are heard. If the program ends, does not read or
// does not answer in time, this instance has failed.
#pragma once

#include <filesystem>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// `programs`: where moonshine.mjs may be, the best place first.
PluginFactory
moonshine_asr_factory(std::vector<std::filesystem::path> programs);

} // namespace parlour::adapters
