#include "tools/parlour/status/running_nodes.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include "tools/parlour/status/runtime_folder.hpp"

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

// All until the other end closes; nothing where that does not come in time.
std::optional<std::string> read_all(const Descriptor& socket) {
  std::string text;
  char buffer[4096];
  for (;;) {
    const auto size = ::read(socket.get(), buffer, sizeof buffer);
    if (size == 0)
      return text;
    if (size < 0 && errno != EINTR)
      return std::nullopt;
    if (size > 0)
      text.append(buffer, static_cast<std::size_t>(size));
  }
}

std::vector<fs::path> sockets_in(const fs::path& folder) {
  std::vector<fs::path> all;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (entry.path().extension() == ".sock")
      all.push_back(entry.path());
  std::ranges::sort(all, {}, [](const fs::path& path) {
    return std::atol(path.stem().c_str());
  });
  return all;
}

} // namespace

std::string to_json(const RunningNode& node) {
  const Json json = {{"application", node.application},
                     {"folder", node.folder},
                     {"process", node.process}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Expected<RunningNode> node_from_json(const std::string& text) {
  try {
    const auto json = Json::parse(text);
    return RunningNode{json.at("application"), json.at("folder"),
                       json.at("process")};
  } catch (const Json::exception& thrown) {
    return fail(ErrorKind::network,
                std::string("nobody says who runs: ") + thrown.what());
  }
}

bool is_meant(const Places& places, const std::string& app,
              const std::string& application, const std::string& folder) {
  std::error_code code;
  return app.empty() || application == app ||
         fs::equivalent(places.working / app, folder, code);
}

std::string also_running(const std::vector<std::string>& applications) {
  std::string text;
  for (const auto& one : applications)
    text += (text.empty() ? "; running: " : ", ") + one;
  return text;
}

Expected<Descriptor> ask(const fs::path& path, const std::string& question,
                         Milliseconds patience) {
  Descriptor made(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.string().copy(address.sun_path, sizeof address.sun_path - 1);
  if (connect(made.get(), reinterpret_cast<sockaddr*>(&address),
              sizeof address) != 0) {
    const int why = errno;
    if (why == ECONNREFUSED) // nobody is there any more
      unlink(path.c_str());
    return fail(ErrorKind::network, path.string() + ": " + std::strerror(why));
  }
  const timeval limit{patience.count() / 1'000,
                      patience.count() % 1'000 * 1'000};
  setsockopt(made.get(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
  const auto line = question + "\n";
  send(made.get(), line.data(), line.size(), MSG_NOSIGNAL);
  return made;
}

Expected<std::string> answer_to(const fs::path& path,
                                const std::string& question,
                                Milliseconds patience) {
  return ask(path, question, patience)
      .and_then([&](const Descriptor& socket) -> Expected<std::string> {
        if (auto text = read_all(socket))
          return *std::move(text);
        return fail(ErrorKind::timeout, "process " + path.stem().string() +
                                            " does not say how it is");
      });
}

std::vector<Expected<std::string>> answers_to(const fs::path& folder,
                                              const std::string& question) {
  std::vector<Expected<std::string>> all;
  for (const auto& path : sockets_in(folder)) {
    auto answer = answer_to(path, question);
    if (answer || answer.error().kind != ErrorKind::network)
      all.push_back(std::move(answer));
  }
  return all;
}

Expected<RunningNode> the_node(const Places& places, const std::string& app) {
  const auto folder = runtime_folder(places);
  std::vector<RunningNode> meant;
  std::vector<std::string> names;
  for (const auto& answer : answers_to(folder, questions::who))
    if (auto node = answer ? node_from_json(*answer)
                           : Expected<RunningNode>(
                                 tl::make_unexpected(answer.error()))) {
      names.push_back(node->application);
      node->socket = folder / (std::to_string(node->process) + ".sock");
      if (is_meant(places, app, node->application, node->folder))
        meant.push_back(std::move(*node));
    }
  if (meant.size() == 1)
    return meant.front();
  const auto what =
      app.empty() ? std::string("no application") : "'" + app + "'";
  if (meant.empty())
    return fail(ErrorKind::settings,
                (app.empty() ? "no application runs" : what + " does not run") +
                    also_running(names) + "; start one with parlour serve APP");
  return fail(ErrorKind::settings,
              "there are several" + also_running(names) +
                  "; say which one, by its name or its folder");
}

} // namespace parlour::tools
