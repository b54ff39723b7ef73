// KeySource: where the movements of one key come from. Opened and read by one
// thread at a time; no call waits.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "adapters/push_to_talk/key_names.hpp"

namespace parlour::adapters {

// `typed` comes from terminals, which do not tell the others apart.
enum class KeyMove : std::uint8_t { pressed, released, typed };

class KeySource {
public:
  // An input device of the kernel, "/dev/input/event3". Errors are of kind
  // Settings if there is no such device, else of kind Offline.
  static Expected<std::unique_ptr<KeySource>>
  open_device(const std::string& path, const KeyName& key);
  // A terminal: it shows no more what is typed, and lines have no meaning,
  // until the source is destroyed. Ctrl-C still ends the program.
  static Expected<std::unique_ptr<KeySource>>
  open_terminal(const std::string& path, const KeyName& key);

  virtual ~KeySource() = default;

  // Is ready for reading when there is a movement.
  virtual int descriptor() const = 0;
  // Appends what has happened since; false if the device is gone.
  virtual bool read(std::vector<KeyMove>& moves) = 0;
};

} // namespace parlour::adapters
