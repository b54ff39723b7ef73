// Folder is an open folder of the disk, from which files and folders below it
// are opened. No function follows a link, and each opens one part of a name
// relative to an open folder. So a path cannot leave the data folder, even if
// somebody replaces folders by links at the same time.
//
//  const auto data = Folder::open("/var/lib/app/data", Missing::refuse);
//  const auto notes = data->folder("notes", Missing::make);
//  const auto file = notes->file("today.txt", O_RDONLY);
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/outside/descriptor.hpp"

namespace parlour::adapters {

// What to do about a folder that does not exist.
enum class Missing : bool { refuse, make };

// Not thread-safe with regard to errno, which tells what the system reported.
// All errors have the kind File.
class Folder {
public:
  // Opens a folder by its path, or a folder inside of this one.
  static Expected<Folder> open(const std::filesystem::path& path,
                               Missing missing);
  Expected<Folder> folder(const std::string& name, Missing missing) const;

  // Opens a regular file. Refuses links, pipes and devices, and files with a
  // second name (hard link), which may lie outside of the data folder. `flags`
  // are those of open().
  Expected<Descriptor> file(const std::string& name, int flags) const;

  // The names in the folder, unsorted, "." and ".." included. Fails if there
  // are more than `most`.
  Expected<std::vector<std::string>> names(std::size_t most) const;
  enum class What : std::uint8_t { nothing, file, folder, other };
  // What kind of thing has this name. A link counts as `other`.
  What what(const std::string& name) const;

  int get() const {
    return descriptor_.get();
  }

private:
  explicit Folder(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}

  Descriptor descriptor_;
};

// An error with the system's reason for the last call that failed: "…: No such
// file or directory".
tl::unexpected<Error> system_trouble(const std::string& what);

} // namespace parlour::adapters
