// add_voice: gives an application a voice seat (docs/speech.md). It adds a
// component for each role of the chain from microphone to speaker that the
// settings leave open, and the library "voice", which connects them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "runtime/base/error.hpp"
#include "runtime/base/settings.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// What the command line says of the devices. Empty: the default device.
struct VoiceWishes {
  std::string microphone; // a device of ALSA, or a file NAME.wav or NAME.flac
  std::string speaker;
};

// What a voice changes in the application.
struct VoiceSources {
  std::function<void(Settings&)> adjust;
  std::string library; // that connects the components; empty: no voice

  Sources sources() const {
    Sources sources;
    sources.adjust = adjust;
    if (!library.empty())
      sources.libraries = {library};
    return sources;
  }
};

// A device of the command line takes the place of all components of its role;
// every other role that is open gets the first plug-in that this build has. An
// error names the role for which it has none.
Expected<VoiceSources> add_voice(const std::filesystem::path& folder,
                                 const std::filesystem::path& platform,
                                 Catalogue& plugins, const VoiceWishes& wishes);

// Gives the components that add_voice chose for files of the command line these
// files, relative to `folder`.
void use_files(Composition& composition, const VoiceWishes& wishes,
               const std::filesystem::path& folder);

} // namespace parlour::tools
