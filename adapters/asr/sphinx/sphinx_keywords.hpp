// SphinxKeywords is a plug-in for the role KeywordSpotter by PocketSphinx: it
// listens all the time and tells when one of its phrases is said. No sample of
// the phrase is needed; English.
//
//  Process(audio, position?)
//      The next audio of the session. Keyword(text, confidence, position) if a
//      phrase is found in it: `position`, in ms, is where this audio ends; the
//      phrase ended up to 200 ms before. `confidence` is 0.5 to 1.
//      Failed(reason), once, if too many sessions listen.
//  SetKeywords(list)
//      Looks only for these phrases from now on, in all sessions.
//      Failed(reason) if it is unknown how one of them sounds; then all stays
//      as it is.
//
// Options: see sphinx_keywords.cpp. Each session has a search of its own; one
// that has said nothing for five seconds may lose it to another. A search takes
// 3 % of the time it hears. Phrases of seven sounds and more ("hey
// parlour") are told from other speech well, shorter ones badly.
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory sphinx_keywords_factory();

} // namespace parlour::adapters
