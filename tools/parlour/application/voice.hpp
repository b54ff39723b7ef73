// add_voice: gives an application a voice seat (docs/speech.md). It adds a
// component for each role of the chain from microphone to speaker that the
// settings leave open, and the library "voice", which connects them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/settings.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// What the command line says of the devices. Empty: the default device.
struct VoiceWishes {
  std::string microphone; // a device of ALSA, or a file NAME.wav or NAME.flac
  std::string speaker;
  // Turns begin and end by a key: "terminal", or an input device of the kernel.
  // Empty: by what the detector hears.
  std::string push_to_talk = {};
  std::string talk_key = {}; // empty: the component's default
  // The words that wake it, separated by commas.
  std::string wake = {};
  // A plug-in of the role ASR; empty: as the settings say, or the best one.
  std::string recogniser = {};
};

// The value of push_to_talk for a key of the terminal.
inline constexpr const char* terminal_key = "terminal";

// What a voice changes in the application.
struct VoiceSources {
  std::function<void(Settings&)> adjust;
  std::vector<std::string> libraries; // that connect the components

  Sources sources() const {
    Sources sources;
    sources.adjust = adjust;
    sources.libraries = libraries;
    return sources;
  }
};

// A device of the command line takes the place of all components of its role,
// and a key also that of the endpointer; every other role that is open gets the
// first plug-in that this build has. An error names the role for which it has
// none. With words that wake it, or a KeywordSpotter in the settings, the seat
// sleeps until it is woken; a key needs no word.
Expected<VoiceSources> add_voice(const std::filesystem::path& folder,
                                 const std::filesystem::path& platform,
                                 Catalogue& plugins, const VoiceWishes& wishes);

// Gives the components that add_voice chose for files of the command line these
// files, relative to `folder`.
void use_files(Composition& composition, const VoiceWishes& wishes,
               const std::filesystem::path& folder);

} // namespace parlour::tools
