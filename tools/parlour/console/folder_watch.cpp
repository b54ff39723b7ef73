// FolderWatch on inotify, which watches single folders: for a whole tree, each
// subfolder is added, and new ones as they appear. inotify follows a folder,
// not its name. So of a path that is not there, the nearest folder above it is
// watched for the name that is missing.
#include "tools/parlour/console/folder_watch.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <sys/inotify.h>
#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

using Steady = std::chrono::steady_clock;

// Events of a folder's files that count, and the folder's own new name. A file
// that is being written counts only when it is closed.
constexpr std::uint32_t changes = IN_CLOSE_WRITE | IN_CREATE | IN_DELETE |
                                  IN_MOVED_FROM | IN_MOVED_TO | IN_MOVE_SELF;
constexpr std::uint32_t arrivals = IN_CREATE | IN_MOVED_TO;

// Whether `path` is `folder` or stands in it.
bool is_within(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end())
             .first == folder.end();
}

// Absolute, and without the slash with which a folder may end.
fs::path whole(const fs::path& path) {
  std::error_code ignored;
  auto full = fs::absolute(path, ignored).lexically_normal();
  return full.has_filename() ? full : full.parent_path();
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

std::string name_in(const inotify_event& event) {
  return event.len > 0 ? event.name : "";
}

// Backup, swap and lock files that editors create beside a file. Vim tests a
// folder with a file called 4913.
bool is_of_an_editor(std::string_view name) {
  return name.ends_with('~') || name.ends_with(".swp") ||
         name.ends_with(".swx") || name.starts_with(".#") || name == "4913";
}

} // namespace

Expected<FolderWatch> FolderWatch::open() {
  const auto descriptor = inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
  if (descriptor < 0)
    return fail(ErrorKind::file, std::string("files cannot be watched: ") +
                                     std::strerror(errno));
  return FolderWatch(descriptor);
}

FolderWatch::FolderWatch(FolderWatch&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      roots_(std::move(other.roots_)), folders_(std::move(other.folders_)) {}

FolderWatch::~FolderWatch() {
  if (descriptor_ >= 0)
    close(descriptor_);
}

void FolderWatch::add(const fs::path& path) {
  follow(roots_.emplace_back(whole(path)));
}

// A single file is watched through its folder, because editors replace files by
// renaming, and a watch on the file would follow the old one.
void FolderWatch::follow(const fs::path& root) {
  if (is_folder(root))
    return watch_tree(root);
  for (auto missing = root; missing.has_relative_path();
       missing = missing.parent_path()) {
    if (!is_folder(missing.parent_path()))
      continue;
    watch(missing.parent_path(), missing.filename().string());
    // It may have come before it was watched for.
    return is_folder(missing) ? follow(root) : void();
  }
}

void FolderWatch::watch_tree(const fs::path& folder) {
  watch(folder, "");
  constexpr auto skip = fs::directory_options::skip_permission_denied;
  // A folder may vanish while it is read.
  std::error_code gone;
  for (fs::recursive_directory_iterator at(folder, skip, gone), end;
       !gone && at != end; at.increment(gone))
    if (is_folder(at->path()))
      watch(at->path(), "");
}

// inotify returns the same id for a folder that is watched already, perhaps
// under its former name. A folder that is watched as a whole stays so.
void FolderWatch::watch(const fs::path& folder, const std::string& file) {
  const auto id = inotify_add_watch(descriptor_, folder.c_str(), changes);
  if (id < 0)
    return;
  const auto [found, fresh] = folders_.try_emplace(id, Folder{folder, {}});
  found->second.path = folder;
  auto& files = found->second.files;
  if (file.empty())
    files.clear();
  else if (fresh || !files.empty())
    files.insert(file);
}

bool FolderWatch::take(const inotify_event& event) {
  if (event.mask & IN_Q_OVERFLOW) // the kernel dropped events
    return true;
  const auto found = folders_.find(event.wd);
  if (found == folders_.end())
    return false;
  if (event.mask & (IN_IGNORED | IN_MOVE_SELF)) {
    lose(event);
    return false;
  }
  const auto [path, files] = found->second;
  const auto name = name_in(event);
  if (event.mask & IN_ISDIR && event.mask & arrivals)
    arrived(path / name, files.empty());
  return files.empty() ? !is_of_an_editor(name) : files.contains(name);
}

// A folder has come: a new one of a tree, or what a root was waiting for.
void FolderWatch::arrived(const fs::path& folder, bool of_a_tree) {
  if (of_a_tree)
    watch_tree(folder);
  for (const auto& root : roots_)
    if (is_within(root, folder))
      follow(root);
}

// A watched folder was deleted, or has another name. If the name is that of the
// same folder still, it was moved within a tree and is watched already.
void FolderWatch::lose(const inotify_event& event) {
  const auto path = folders_.at(event.wd).path;
  if (event.mask & IN_MOVE_SELF) {
    if (inotify_add_watch(descriptor_, path.c_str(), changes) == event.wd)
      return;
    std::erase_if(folders_, [&](const auto& entry) {
      return is_within(entry.second.path, path) &&
             inotify_rm_watch(descriptor_, entry.first) == 0;
    });
  }
  folders_.erase(event.wd);
  for (const auto& root : roots_)
    if (is_within(root, path))
      follow(root);
}

// inotify packs several events of different length into one read.
bool FolderWatch::changed() {
  alignas(inotify_event) char buffer[4096];
  bool matters = false;
  for (auto size = ::read(descriptor_, buffer, sizeof buffer); size > 0;
       size = ::read(descriptor_, buffer, sizeof buffer))
    for (const char* at = buffer; at < buffer + size;) {
      const auto& event = *reinterpret_cast<const inotify_event*>(at);
      matters |= take(event);
      at += sizeof event + event.len;
    }
  return matters;
}

// Waits without limit for the first change, then for a pause of `settled`.
bool FolderWatch::wait(int stop, Milliseconds settled) {
  bool has_changed = false;
  for (;;) {
    pollfd waiting[] = {{descriptor_, POLLIN, 0}, {stop, POLLIN, 0}};
    const auto deadline =
        has_changed ? Steady::now() + settled : Steady::time_point::max();
    const auto waited = adapters::wait_until_ready(waiting, deadline);
    if (waited == adapters::Waited::failed || waiting[1].revents & POLLIN)
      return false;
    if (waited == adapters::Waited::late)
      return true;
    has_changed |= changed();
  }
}

} // namespace parlour::tools
