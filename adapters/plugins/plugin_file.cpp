// The steps of loading, each with errors of its own: copy the file, check its
// length, load it, find its declaration, compare versions, ask for the factory.
// A library that fails after it was loaded stays loaded, too; unloading code is
// never safe here.
#include "adapters/plugins/plugin_file.hpp"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <system_error>
#include <utility>

#include <dlfcn.h>

#include "adapters/plugins/shared_object.hpp"
#include "runtime/plugin/export.hpp"

namespace parlour::adapters {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> unusable(const fs::path& file, const std::string& why) {
  return fail(ErrorKind::settings,
              "the plug-in " + file.string() + " cannot be used: " + why);
}

// A temporary folder for one copy, removed at the end of the scope. The library
// stays loaded after its file has been removed.
class CopyFolder {
public:
  static tl::expected<CopyFolder, std::error_code> make() {
    std::error_code code;
    auto pattern =
        (fs::temp_directory_path(code) / "parlour-plugin-XXXXXX").string();
    if (code)
      return tl::make_unexpected(code);
    if (!mkdtemp(pattern.data()))
      return tl::make_unexpected(
          std::error_code(errno, std::generic_category()));
    return CopyFolder(pattern);
  }
  CopyFolder(CopyFolder&& other) noexcept : path_(std::move(other.path_)) {
    other.path_.clear();
  }
  ~CopyFolder() {
    std::error_code ignored;
    if (!path_.empty())
      fs::remove_all(path_, ignored);
  }

  // The loader recognises a library by its name: a second copy of the same name
  // would not be loaded. So each copy has a number.
  fs::path name_for(const fs::path& file) const {
    static std::atomic<unsigned> count = 0;
    return path_ / (std::to_string(++count) + "-" + file.filename().string());
  }

private:
  explicit CopyFolder(fs::path path) : path_(std::move(path)) {}
  fs::path path_;
};

// The loader's message names the copy, which means nothing to the user.
std::string loader_error(const fs::path& copy, const fs::path& file) {
  const auto* said = dlerror();
  std::string text = said ? said : "the loader says nothing";
  if (const auto at = text.find(copy.string()); at != std::string::npos)
    text.replace(at, copy.string().size(), file.filename().string());
  return text;
}

// RTLD_NOW reports missing symbols here instead of in a call; RTLD_LOCAL keeps
// the symbols of plug-ins apart.
Expected<void*> map_copy(const fs::path& file) {
  const auto folder = CopyFolder::make();
  if (!folder)
    return unusable(file, std::string("no folder for a copy of it can be made "
                                      "(TMPDIR says where): ") +
                              folder.error().message());
  const auto copy = folder->name_for(file);
  std::error_code code;
  if (!fs::copy_file(file, copy, code))
    return unusable(file, code.message());
  if (is_cut_off(copy))
    return unusable(file, "it is cut off; copy or build it again");
  auto* library = dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
    return unusable(file, loader_error(copy, file) +
                              "; build it again with this Parlour");
  return library;
}

// Nothing of the library may be called before interface and ABI have been
// compared.
Expected<const PluginLibrary*> declaration(void* library,
                                           const fs::path& file) {
  const auto* found =
      static_cast<const PluginLibrary*>(dlsym(library, plugin_symbol));
  if (!found)
    return unusable(file, "it is no plug-in of Parlour; its source ends with "
                          "PARLOUR_PLUGIN(Class, description)");
  if (found->interface != plugin_interface)
    return unusable(
        file, "it was built for interface " + std::to_string(found->interface) +
                  " of plug-ins, this is " + std::to_string(plugin_interface) +
                  "; build it again with this Parlour");
  if (found->abi != PluginAbi{})
    return unusable(file, "its compiler, or its compiler's settings, lay types "
                          "out otherwise; build it again with this Parlour");
  return found;
}

Expected<PluginFactory> factory_of(const PluginLibrary& library,
                                   const fs::path& file) {
  PluginFactory factory;
  try {
    factory = library.factory();
  } catch (const std::exception& error) {
    return unusable(file, std::string("it fails to describe itself: ") +
                              error.what());
  } catch (...) {
    return unusable(file, "it fails to describe itself");
  }
  const auto& name = factory.description.name;
  if (name != file.stem())
    return unusable(file, "it holds the plug-in '" + name +
                              "'; call the file " + name + ".so");
  return factory;
}

} // namespace

Expected<PluginFactory> open_plugin_file(const fs::path& file) {
  std::error_code code;
  if (!fs::is_regular_file(file, code))
    return unusable(file, "there is no such file");
  const auto library = map_copy(file);
  if (!library)
    return tl::make_unexpected(library.error());
  const auto found = declaration(*library, file);
  if (!found)
    return tl::make_unexpected(found.error());
  return factory_of(**found, file);
}

} // namespace parlour::adapters
