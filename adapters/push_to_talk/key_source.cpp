#include "adapters/push_to_talk/key_source.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/input.h>
#include <termios.h>
#include <unistd.h>

#include "runtime/base/outside/descriptor.hpp"

namespace parlour::adapters {

namespace {

Descriptor open_to_read(const std::string& path, int more = 0) {
  return Descriptor(
      ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | more));
}

// Reads at most `size` bytes: their number; nothing if the device is gone.
std::optional<std::size_t> read_bytes(int descriptor, void* bytes,
                                      std::size_t size) {
  for (;;) {
    const auto count = ::read(descriptor, bytes, size);
    if (count > 0)
      return static_cast<std::size_t>(count);
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0 && errno == EAGAIN)
      return 0;
    return std::nullopt;
  }
}

// -- input devices
// -------------------------------------------------------------

class DeviceKeys : public KeySource {
public:
  DeviceKeys(Descriptor device, const KeyName& key)
      : device_(std::move(device)), key_(key) {}

  int descriptor() const override {
    return device_.get();
  }

  bool read(std::vector<KeyMove>& moves) override {
    for (;;) {
      const auto count = read_bytes(device_.get(), bytes_.data() + kept_,
                                    bytes_.size() - kept_);
      if (!count || *count == 0)
        return count.has_value();
      kept_ += *count;
      take_events(moves);
    }
  }

private:
  // A pipe may cut an event in two.
  void take_events(std::vector<KeyMove>& moves) {
    std::size_t used = 0;
    for (; kept_ - used >= sizeof(input_event); used += sizeof(input_event)) {
      input_event event;
      std::memcpy(&event, bytes_.data() + used, sizeof event);
      take(event, moves);
    }
    std::memmove(bytes_.data(), bytes_.data() + used, kept_ - used);
    kept_ -= used;
  }

  // Of events that the kernel had to drop nobody knows whether they held the
  // release: a microphone had better hear too little than too much.
  void take(const input_event& event, std::vector<KeyMove>& moves) const {
    if (event.type == EV_SYN && event.code == SYN_DROPPED)
      moves.push_back(KeyMove::released);
    if (event.type != EV_KEY || (key_.code && event.code != *key_.code))
      return;
    if (event.value == 1)
      moves.push_back(KeyMove::pressed);
    else if (event.value == 0) // 2: it is held, and repeats
      moves.push_back(KeyMove::released);
  }

  Descriptor device_;
  KeyName key_;
  std::array<std::byte, 64 * sizeof(input_event)> bytes_{};
  std::size_t kept_ = 0;
};

// -- terminals
// -----------------------------------------------------------------

class TerminalKeys : public KeySource {
public:
  TerminalKeys(Descriptor terminal, const termios& before, const KeyName& key)
      : terminal_(std::move(terminal)), before_(before), key_(key) {}
  TerminalKeys(const TerminalKeys&) = delete;
  TerminalKeys& operator=(const TerminalKeys&) = delete;
  ~TerminalKeys() override {
    ::tcsetattr(terminal_.get(), TCSANOW, &before_);
  }

  int descriptor() const override {
    return terminal_.get();
  }

  bool read(std::vector<KeyMove>& moves) override {
    std::array<char, 256> bytes;
    for (;;) {
      const auto count =
          read_bytes(terminal_.get(), bytes.data(), bytes.size());
      if (!count || *count == 0)
        return count.has_value();
      for (std::size_t i = 0; i < *count; ++i)
        if (!key_.typed || bytes[i] == *key_.typed)
          moves.push_back(KeyMove::typed);
    }
  }

private:
  Descriptor terminal_;
  termios before_;
  KeyName key_;
};

} // namespace

Expected<std::unique_ptr<KeySource>>
KeySource::open_device(const std::string& path, const KeyName& key) {
  auto device = open_to_read(path);
  if (device)
    return std::make_unique<DeviceKeys>(std::move(device), key);
  const bool is_missing = errno == ENOENT || errno == ENODEV || errno == ENXIO;
  const auto reason = is_missing ? "there is no such device"
                      : errno == EACCES
                          ? "this user may not read it; the group \"input\" may"
                          : std::generic_category().message(errno);
  return fail(is_missing ? ErrorKind::settings : ErrorKind::offline,
              fmt::format("the input device \"{}\" cannot be used: {} "
                          "(/proc/bus/input/devices lists what there is)",
                          path, reason));
}

// Only one key in a row is looked for, so a key that sends several bytes, such
// as an arrow, might be taken for several.
Expected<std::unique_ptr<KeySource>>
KeySource::open_terminal(const std::string& path, const KeyName& key) {
  if (key.code && !key.typed)
    return fail(ErrorKind::settings,
                "a terminal does not tell of this key; use space, enter, tab, "
                "a letter or a figure, or name an input device");
  auto terminal = open_to_read(path, O_NOCTTY);
  termios mode{};
  if (!terminal || ::tcgetattr(terminal.get(), &mode) != 0)
    return fail(ErrorKind::settings,
                "there is no terminal that could tell of a key; name an input "
                "device, such as /dev/input/event3");
  const auto before = mode;
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  mode.c_iflag &= ~static_cast<tcflag_t>(ICRNL);
  mode.c_cc[VMIN] = 1;
  mode.c_cc[VTIME] = 0;
  ::tcsetattr(terminal.get(), TCSANOW, &mode);
  return std::make_unique<TerminalKeys>(std::move(terminal), before, key);
}

} // namespace parlour::adapters
