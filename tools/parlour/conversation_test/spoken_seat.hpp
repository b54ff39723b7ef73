// How lines of a conversation file are spoken into the application: what
// conversation_runner needs of voice_test.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::actors {
class Node;
}

namespace parlour::tools {

// The seat of one conversation. For one thread at a time; it outlives the node.
class SpokenSeat {
public:
  virtual ~SpokenSeat() = default;

  // The application with the seat's microphone, and a speaker whose file goes
  // with the data folder.
  virtual Composition seated(Composition composition,
                             const std::filesystem::path& data) = 0;
  // Takes an inspection of any kind, and what the robot says.
  virtual void note(const Inspection& seen) = 0;
  virtual void released(std::uint64_t id, const std::string& text) = 0;

  // Speaks the line (`U(…):`, `P(…):`, `B(…):`), and lets time pass until it is
  // recognised.
  virtual void speak(actors::Node& node, const Step& step) = 0;
  // Lets time pass until the robot has spoken to its end.
  virtual void settle(actors::Node& node) = 0;
  // How long it took from the user's last sound to the robot's first one;
  // nothing if that does not come.
  virtual std::optional<Milliseconds> first_sound(actors::Node& node) = 0;
};

// Where conversations with spoken lines get their seats. Thread-safe.
class SpokenSeats {
public:
  virtual ~SpokenSeats() = default;

  // The application with a voice.
  virtual const Application& application() const = 0;
  virtual std::unique_ptr<SpokenSeat> make() = 0;
};

} // namespace parlour::tools
