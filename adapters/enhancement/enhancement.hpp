// WebRtcEnhancement is a plug-in for the role Enhancement: it takes the echo of
// what the loudspeaker plays out of what the microphone hears.
//
//  Process(audio, position?)
//      Enhanced(audio, position): the same audio, enhanced. Without a position
//      the audio follows what came before.
//  SetEcho(audio)
//      What the loudspeaker plays now.
//
// While nothing plays, the audio passes unchanged, unless options ask for more:
// noise-suppression (false; it doubles word errors among voices),
// gain-control (false), delay (0ms): the least time from playing to hearing.
//
// Each session has a stream of its own; the least recently used is dropped when
// there are too many.
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory webrtc_enhancement_factory();

} // namespace parlour::adapters
