// FolderWatch: waits until a file in some folders is written, created, moved or
// deleted. It uses inotify, so it needs no processor time while it waits.
//
//   auto watch = FolderWatch::open();
//   watch->add("config/apps/lab");
//   while (watch->wait(stop_descriptor))
//     test_again();
//
// For one thread at a time.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

struct inotify_event;

namespace parlour::tools {

class FolderWatch {
public:
  // An error of kind File if the system has no more inotify instances.
  static Expected<FolderWatch> open();
  FolderWatch(FolderWatch&& other) noexcept;
  FolderWatch& operator=(FolderWatch&&) = delete;
  ~FolderWatch();

  // Watches a folder with all its subfolders, including later ones, or one
  // file. What the path names may be missing, or be deleted, and come (again)
  // later. Changes of editors' backup and swap files do not count. A folder
  // that may not be read is ignored.
  void add(const std::filesystem::path& path);

  // Whether something has changed since the last call. Does not block.
  bool changed();
  // Blocks until something changes and then nothing changes for `settled`, so
  // that an editor that saves in several steps counts once; returns true.
  // Returns false as soon as `stop` is readable, or if watching fails. Changes
  // between two calls are not lost.
  bool wait(int stop, Milliseconds settled = Milliseconds(100));

private:
  explicit FolderWatch(int descriptor) : descriptor_(descriptor) {}
  // A watched folder. If `files` is empty, every file in it counts.
  struct Folder {
    std::filesystem::path path;
    std::set<std::string> files; // empty: all
  };
  void follow(const std::filesystem::path& root);
  void watch_tree(const std::filesystem::path& folder);
  // Adds one folder to the inotify instance; `file` empty: all of its files.
  void watch(const std::filesystem::path& folder, const std::string& file);
  // Whether the event counts. Also follows what comes and goes.
  bool take(const inotify_event& event);
  void arrived(const std::filesystem::path& folder, bool of_a_tree);
  void lose(const inotify_event& event);

  int descriptor_;
  std::vector<std::filesystem::path> roots_; // what was added
  std::map<int, Folder> folders_;            // by inotify watch descriptor
};

} // namespace parlour::tools
