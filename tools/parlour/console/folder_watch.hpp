// FolderWatch: waits until a file below some folders is written, made, moved or
// deleted. It sleeps in the kernel (inotify) and costs nothing meanwhile.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

struct inotify_event;

namespace parlour::tools {

class FolderWatch {
public:
  static Expected<FolderWatch> open();
  FolderWatch(FolderWatch&& other) noexcept;
  FolderWatch& operator=(FolderWatch&&) = delete;
  ~FolderWatch();

  // A folder with all that are below it, or one file, which may come and go.
  void add(const std::filesystem::path& path);

  // Whether something has changed since it was last asked; waits for nothing.
  bool changed();
  // True when something changed and then nothing did for `settled`, so that an
  // editor that writes in several steps counts once. False when `stop` is
  // readable. Changes between two calls are not lost.
  bool wait(int stop, Milliseconds settled = Milliseconds(100));

private:
  explicit FolderWatch(int descriptor) : descriptor_(descriptor) {}
  struct Folder {
    std::filesystem::path path;
    std::set<std::string> files; // that count; empty: all
  };
  void watch(const std::filesystem::path& folder, const std::string& file);
  bool take(const inotify_event& event); // whether it matters

  int descriptor_;
  std::map<int, Folder> folders_; // by watch
};

} // namespace parlour::tools
