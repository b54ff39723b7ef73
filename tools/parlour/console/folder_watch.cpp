#include "tools/parlour/console/folder_watch.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t changes =
    IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO;

// What editors keep beside a file while they write it.
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
      folders_(std::move(other.folders_)) {}

FolderWatch::~FolderWatch() {
  if (descriptor_ >= 0)
    close(descriptor_);
}

// A folder that is watched as a whole stays so.
void FolderWatch::watch(const fs::path& folder, const std::string& file) {
  const auto id = inotify_add_watch(descriptor_, folder.c_str(), changes);
  if (id < 0)
    return;
  const auto [found, fresh] = folders_.try_emplace(id, Folder{folder, {}});
  auto& files = found->second.files;
  if (file.empty())
    files.clear();
  else if (fresh || !files.empty())
    files.insert(file);
}

void FolderWatch::add(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored))
    return watch(path.parent_path(), path.filename().string());
  watch(path, "");
  constexpr auto skip = fs::directory_options::skip_permission_denied;
  std::error_code gone; // a folder vanishes while it is read
  for (fs::recursive_directory_iterator at(path, skip, gone), end;
       !gone && at != end; at.increment(gone))
    if (at->is_directory(ignored))
      watch(at->path(), "");
}

bool FolderWatch::take(const inotify_event& event) {
  if (event.mask & IN_Q_OVERFLOW) // more happened than was told
    return true;
  const auto found = folders_.find(event.wd);
  if (found == folders_.end())
    return false;
  if (event.mask & IN_IGNORED) { // the folder itself is gone
    folders_.erase(found);
    return false;
  }
  const auto& [path, files] = found->second;
  const std::string name = event.len > 0 ? event.name : "";
  if (files.empty() && event.mask & IN_ISDIR &&
      event.mask & (IN_CREATE | IN_MOVED_TO))
    add(fs::path(path) / name);
  return files.empty() ? !is_of_an_editor(name) : files.contains(name);
}

bool FolderWatch::changed() {
  alignas(inotify_event) char buffer[4096];
  bool matters = false;
  for (auto size = read(descriptor_, buffer, sizeof buffer); size > 0;
       size = read(descriptor_, buffer, sizeof buffer))
    for (const char* at = buffer; at < buffer + size;) {
      const auto& event = *reinterpret_cast<const inotify_event*>(at);
      matters |= take(event);
      at += sizeof event + event.len;
    }
  return matters;
}

bool FolderWatch::wait(int stop, Milliseconds settled) {
  bool has_changed = false;
  for (;;) {
    pollfd waiting[] = {{descriptor_, POLLIN, 0}, {stop, POLLIN, 0}};
    const auto ready =
        poll(waiting, 2, has_changed ? static_cast<int>(settled.count()) : -1);
    if (waiting[1].revents & POLLIN)
      return false;
    if (ready == 0)
      return true;
    if (ready > 0)
      has_changed |= changed();
    else if (errno != EINTR)
      return false;
  }
}

} // namespace parlour::tools
