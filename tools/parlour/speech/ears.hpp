// Ears: the components of an application from enhancement to recogniser, which
// hear sound files without a conversation. parlour:voice and parlour:voice-wake
// connect them in the same way.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "adapters/audio/level_meter.hpp"
#include "adapters/audio/sound_file_frames.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// What was told of a turn. Positions are in ms of the file.
struct HeardTurn {
  struct Partial {
    std::int64_t position = 0; // of the audio when it was told
    std::string text;
    std::optional<bool> ends;
  };
  std::int64_t begin = 0; // of its speech
  std::int64_t end = 0;
  std::vector<Partial> partials = {};
  std::string text = {}; // empty: nothing was recognised
  Value confidence = {}; // unknown: the recogniser has none
  List alternatives = {};
  List words = {};
  std::string rejected = {}; // why nothing was recognised
};

struct HeardFile {
  struct Segment {
    std::int64_t begin = 0;
    std::int64_t end = 0;
  };
  // A phrase that wakes the seat.
  struct Keyword {
    std::int64_t position = 0;
    std::string text;
    Value confidence;
  };
  std::int64_t length = 0; // ms
  adapters::LevelMeter level = {};
  std::vector<Segment> speech = {}; // by the detector
  std::vector<HeardTurn> turns = {};
  std::vector<Keyword> keywords = {};
  // Nothing is a turn before a keyword.
  bool sleeps = false;
};

// For one thread.
class Ears {
public:
  // Starts the components; the application must outlive them.
  static Expected<std::unique_ptr<Ears>> start(const Application& application);
  Ears(const Ears&) = delete;
  Ears& operator=(const Ears&) = delete;
  ~Ears();

  // Hears a file and two seconds of silence: at the pace of speech if one of
  // the components works aside, else as fast as they hear. Errors are those of
  // the file, of kind Offline if a component is not available or the recogniser
  // does not answer, and what a component throws.
  Expected<HeardFile> hear(const std::filesystem::path& file);
  // The same for samples, as fast as they are heard, without silence behind
  // them.
  Expected<HeardFile> hear(std::span<const adapters::Sample> sound);

  const std::string& recogniser() const;

private:
  class Stage;
  class Hearing;
  Ears();
  std::vector<Stage*> stages() const;
  // Nothing was heard before. An error names who is not available.
  Expected<void> begin();

  std::unique_ptr<Stage> enhancement_; // null: there is none
  std::unique_ptr<Stage> spotter_;     // null: the seat is always awake
  std::unique_ptr<Stage> detector_;
  std::unique_ptr<Stage> endpointer_;
  std::unique_ptr<Stage> recogniser_;
};

} // namespace parlour::tools
