// SphinxASR is a plug-in for the role ASR by PocketSphinx. What it can hear
// comes from the application: grammars, values, columns, examples and
// conversations (words/language.hpp).
//
//  DoRecognition(audio)
//      The next piece of the session's utterance; it is decoded at once.
//      Partial(text, revision, ends?) every 200 ms if the text changed.
//  Finish()
//      RecognitionResult(text, confidence, alternatives, words), or
//      Rejected(reason) if nothing was heard or two ways of hearing do not
//      agree. `confidence` is their agreement; `alternatives` are both texts,
//      `words` maps with word, begin, end (ms) and agreed.
//  Cancel()
//      The utterance is dropped.
//  SetGrammar(names)
//      Only these grammars, rules, slots or forms are expected in the session's
//      utterances from the next one on, beside what is said in any
//      conversation; an empty list: all.
//
//  SetValues(column, values)
//      The column's values from the next utterance on, once they are prepared,
//      which takes about a second and disturbs nobody.
//
// Options: see sphinx_asr.cpp. Each of the recognisers (option "recognisers")
// hears one utterance at a time; they are made when they are needed, and an
// utterance waits for one: up to 30 s of audio are kept for it.
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory sphinx_asr_factory();

} // namespace parlour::adapters
