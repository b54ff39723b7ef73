// Folder: an open folder of the disk, and the way down from it. Nothing here
// follows a link: each step opens one part of a name beneath an open folder,
// so that whoever exchanges folders for links meanwhile gains nothing.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

// An open file; closed when it goes.
class Descriptor {
public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int get() const {
    return number_;
  }
  int release(); // to whoever closes it
  explicit operator bool() const {
    return number_ >= 0;
  }

private:
  int number_;
};

enum class Missing : bool { refuse, make };

class Folder {
public:
  // Errors of all functions are of kind File; `errno` says what the system
  // said.
  static Expected<Folder> open(const std::filesystem::path& path,
                               Missing missing);
  Expected<Folder> folder(const std::string& name, Missing missing) const;

  // A regular file that has no other name; never a link, a pipe or a device.
  Expected<Descriptor> file(const std::string& name, int flags) const;

  // The names in it, in no order; at most `most` of them.
  Expected<std::vector<std::string>> names(std::size_t most) const;
  enum class What : std::uint8_t { nothing, file, folder, other };
  What what(const std::string& name) const;

  int get() const {
    return descriptor_.get();
  }

private:
  explicit Folder(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}

  Descriptor descriptor_;
};

// "…: No such file or directory", of the last call that failed.
tl::unexpected<Error> system_trouble(const std::string& what);

} // namespace parlour::adapters
