// Files by three ways: scripts of the application, libraries of the platform
// (parlour:name), and a tree that exists already. All of them end in add(),
// which follows the includes first.

#include "script/compiler/application/application_loader.hpp"

#include <algorithm>
#include <utility>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/base/text/paths.hpp"
#include "script/xml/source_reader.hpp"
#include "script/xml/validator.hpp"

namespace parlour::script {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view library_prefix = "parlour:";

} // namespace

ApplicationLoader::ApplicationLoader(fs::path folder, fs::path platform,
                                     Findings& findings,
                                     const SourceTexts* texts)
    : folder_(std::move(folder)), platform_(std::move(platform)),
      findings_(findings), texts_(texts) {}

// An editor's text counts instead of the file that it belongs to.
Expected<std::string> ApplicationLoader::text_of(const fs::path& path) const {
  if (texts_)
    if (const auto found = texts_->find(path.string()); found != texts_->end())
      return found->second;
  return read_bytes(path);
}

// Both paths are compared as real paths, so that a link cannot lead out.
Expected<fs::path> ApplicationLoader::inside(const std::string& name) const {
  const fs::path path(name);
  if (name.empty())
    return fail(ErrorKind::file, "a file's name is empty");
  if (name.find('\0') != std::string::npos || path.is_absolute())
    return fail(ErrorKind::file, "'" + name +
                                     "' must be relative to the "
                                     "application's folder");
  const auto full = (folder_ / path).lexically_normal();
  const auto found = real_path(full);
  const auto folder = real_path(folder_);
  if (found != folder && !is_below(found, folder))
    return fail(ErrorKind::file,
                "'" + name + "' leaves the application's folder");
  if (!is_there(full))
    return fail(ErrorKind::file, "there is no file '" + name + "'");
  return full;
}

std::optional<Element>
// A file that is named somewhere is reported there; otherwise at its own path.
ApplicationLoader::read(const fs::path& path,
                        const std::vector<std::string>& roots,
                        Position position) {
  auto bytes = text_of(path);
  if (!bytes) {
    if (position.line > 0)
      findings_.error(position, path.string() + ": " + bytes.error().message);
    else
      findings_.error({findings_.add_file(path.string()), 0, 0},
                      bytes.error().message);
    return std::nullopt;
  }
  const auto file = findings_.add_file(path.string(), *bytes);
  auto root = read_source(std::move(*bytes), file, findings_);
  if (!root || !validate(*root, roots, findings_))
    return std::nullopt;
  return root;
}

void ApplicationLoader::load_script(const std::string& name,
                                    Position position) {
  const auto path = inside(name);
  if (!path)
    return findings_.error(position, path.error().message);
  load(*path, false, position);
}

void ApplicationLoader::add(const fs::path& path, Element root) {
  add(real_path(path), std::move(root), false);
}

// Two files of the platform's folder are no libraries.
std::vector<std::string> ApplicationLoader::libraries() const {
  std::vector<std::string> names;
  for (const auto& file :
       list_files(platform_, ".xml").value_or(std::vector<fs::path>()))
    if (file.stem() != "aliases" && file.stem() != "settings")
      names.push_back(file.stem().string());
  return names;
}

// A library is a file of the platform's folder; its includes are followed, too.
void ApplicationLoader::load_library(const std::string& name,
                                     Position position) {
  const auto known = libraries();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    auto text = "the platform has no library 'parlour:" + name + "'";
    return findings_.error(position, text + did_you_mean(name, known));
  }
  load(platform_ / (name + ".xml"), true, position);
}

// Where an application without `start` begins (language rule 1.8).
std::string ApplicationLoader::first_state() const {
  for (const auto& document : documents_)
    for (const auto& child : document.root.children)
      if (child.is("state"))
        return child.value("name");
  return {};
}

void ApplicationLoader::include(const Element& element) {
  const auto& href = *element.attribute("href");
  if (href.value.starts_with(library_prefix))
    load_library(href.value.substr(library_prefix.size()), href.value_position);
  else
    load_script(href.value, href.value_position);
}

// `open_` is the chain of includes that are being followed: a file in it closes
// a ring. `read_` has every file that was read, also a broken one, so that its
// errors are reported once.
void ApplicationLoader::load(const fs::path& path, bool platform,
                             Position position) {
  const auto found = real_path(path);
  if (std::find(open_.begin(), open_.end(), found) != open_.end())
    return findings_.error(position, "'" + path.filename().string() +
                                         "' includes this file; files may not "
                                         "include each other");
  if (read_.count(found))
    return;
  if (auto root = read(path, {"dialogue"}, position))
    add(found, std::move(*root), platform);
  read_.insert(found);
}

// Included documents are added before the document that includes them.
void ApplicationLoader::add(const fs::path& real_path, Element root,
                            bool platform) {
  read_.insert(real_path);
  open_.push_back(real_path);
  for (const auto& child : root.children)
    if (child.is("include"))
      include(child);
  open_.pop_back();
  documents_.push_back({std::move(root), platform});
}

} // namespace parlour::script
