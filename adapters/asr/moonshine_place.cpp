#include "adapters/asr/moonshine_place.hpp"

#include <algorithm>
#include <sstream>
#include <system_error>

#include <unistd.h>

namespace parlour::adapters::moonshine {

namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code code;
  return fs::exists(path, code);
}

fs::path full_path(const fs::path& path) {
  std::error_code code;
  return fs::absolute(path, code).lexically_normal();
}

tl::unexpected<Error> missing(const PlaceOrder& order,
                              const std::string& what) {
  return fail(ErrorKind::settings,
              what + ": `tools/dependencies ears` installs what " +
                  order.plugin + " needs; " + order.otherwise +
                  " needs none of it");
}

// As a shell looks for it: a name with a '/' is a path.
fs::path find_node(const PlaceOrder& order) {
  if (order.node.find('/') != std::string::npos)
    return is_there(order.node) ? full_path(order.node) : fs::path();
  std::istringstream folders(order.path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const auto file = fs::path(folder) / order.node;
        !folder.empty() && access(file.c_str(), X_OK) == 0)
      return full_path(file);
  return {};
}

fs::path find_program(const PlaceOrder& order) {
  if (!order.program.empty())
    return is_there(order.program) ? full_path(order.program) : fs::path();
  const auto found = std::ranges::find_if(order.usual, is_there);
  return found == order.usual.end() ? fs::path() : full_path(*found);
}

} // namespace

// The first thing that is missing is told.
Expected<Place> find_place(const PlaceOrder& order) {
  const Place place{find_node(order), find_program(order)};
  if (place.program.empty())
    return missing(order,
                   order.program.empty()
                       ? "the program moonshine.mjs is missing"
                       : "there is no program " + order.program.string());
  if (place.node.empty())
    return missing(order, "there is no program '" + order.node +
                              "' (Node.js 18 or later)");
  const auto folder = place.program.parent_path();
  for (const auto& package : order.packages)
    if (!is_there(folder / "node_modules" / package))
      return missing(order, std::string("the package ") + package +
                                " is missing in " +
                                (folder / "node_modules").string());
  return place;
}

} // namespace parlour::adapters::moonshine
