#include "adapters/files/data_files.hpp"

#include <utility>

#include "adapters/files/data_name.hpp"
#include "adapters/files/file_list.hpp"
#include "adapters/files/file_text.hpp"

namespace parlour::adapters {

namespace {

// Opens the folder of the name's last part, one part at a time. Missing folders
// are created for writing only.
Expected<Folder> parent_of(const std::filesystem::path& data,
                           const std::vector<std::string>& parts,
                           Missing missing) {
  auto folder = Folder::open(data, missing);
  for (std::size_t i = 0; folder && i + 1 < parts.size(); ++i)
    folder = folder->folder(parts[i], missing);
  return folder;
}

// Actions without a result answer unknown.
Expected<Value> act(const Folder& folder, const std::string& name,
                    const FileRequest& request) {
  auto nothing = [] { return Value(); };
  switch (request.action) {
  case FileAction::read:
    return read_text(folder, name, request.max_bytes).map([](std::string text) {
      return Value(std::move(text));
    });
  case FileAction::write:
    return write_text(folder, name, request.text, request.max_bytes)
        .map(nothing);
  case FileAction::append:
    return append_text(folder, name, request.text, request.max_bytes)
        .map(nothing);
  default:
    return remove_file(folder, name).map(nothing);
  }
}

// Messages name the file as the script did.
Error of_request(const FileRequest& request, Error error) {
  // In the order of FileAction.
  constexpr const char* doing[] = {"reading", "writing", "appending to",
                                   "deleting", "listing"};
  error.message = std::string(doing[static_cast<std::size_t>(request.action)]) +
                  ' ' + shown_name(request.name) + ": " + error.message;
  return error;
}

Expected<Value> carry_out(const std::filesystem::path& data,
                          const FileRequest& request) {
  const bool makes = request.action == FileAction::write ||
                     request.action == FileAction::append;
  const auto parts = split_name(request.name);
  if (!parts)
    return tl::make_unexpected(parts.error());
  Expected<Value> outcome;
  if (request.action == FileAction::list) {
    outcome = list_files(data, *parts, request.max_bytes);
  } else {
    const auto folder =
        parent_of(data, *parts, makes ? Missing::make : Missing::refuse);
    outcome = folder ? act(*folder, parts->back(), request)
                     : tl::make_unexpected(folder.error());
  }
  return std::move(outcome).map_error(
      [&](Error error) { return of_request(request, std::move(error)); });
}

} // namespace

FileAccess data_files(std::filesystem::path folder) {
  return [folder = std::move(folder)](const FileRequest& request) {
    return carry_out(folder, request);
  };
}

} // namespace parlour::adapters
