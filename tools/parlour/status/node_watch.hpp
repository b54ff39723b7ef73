// NodeWatch: how a running node is watched from outside of its process: by
// `parlour status`, `top` and `tail`, and over HTTP; and told to `reload`. It
// is made before the node, which shows it what happens, and ends before the
// node stops.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "actors/node/node.hpp"
#include "adapters/web/page_server.hpp"
#include "runtime/base/text/host_and_port.hpp"
#include "tools/parlour/status/metrics_report.hpp"
#include "tools/parlour/status/reload_request.hpp"
#include "tools/parlour/status/status_server.hpp"
#include "tools/parlour/status/tail_hub.hpp"

namespace parlour::tools {

class NodeWatch {
public:
  // Who it is.
  struct Of {
    std::string application; // its name
    std::string folder;      // absolute
    RolesByComponent roles = {};
  };
  explicit NodeWatch(Of of);
  ~NodeWatch(); // as end()

  // From the node's on_inspection.
  void see(const Inspection& seen);

  // All outlive it, or its end. `more`: what others count. Both functions may
  // be empty; `reload` is called on a thread of its own.
  void connect(actors::Node& node, Reload reload = {},
               std::function<Metrics()> more = {});
  // For this user's own commands. The error says why they cannot ask.
  Expected<void> serve_commands(const std::filesystem::path& sockets);
  using Tell = std::function<void(const std::string& line)>;
  // Pages over HTTP: /metrics and /health. Returned is where: an URL. `log` is
  // told of trouble, on the pages' thread.
  Expected<std::string> serve_pages(const HostAndPort& address,
                                    const Tell& log);
  // Both: pages only if an address is given, and then they have to be possible.
  // `log` is told why commands cannot ask, `note` where the pages are.
  Expected<void> serve(const std::filesystem::path& sockets,
                       const std::optional<HostAndPort>& pages, const Tell& log,
                       const Tell& note);
  // Nobody may ask a node that stops.
  void end();

private:
  std::string answer(const std::string& question);
  // Answers when it is done; meanwhile others may ask how the node is.
  void reload(Descriptor connection, const std::string& request);
  ReloadReply carry_out(const std::string& request);
  MetricsReport metrics();
  adapters::web::Page health();

  const Of of_;
  const Nanoseconds begun_;
  std::atomic<actors::Node*> node_ = nullptr;
  Reload reload_;
  std::future<void> reloading_; // the last one
  std::function<Metrics()> more_;
  TailHub tails_;
  std::unique_ptr<StatusServer> commands_;           // null: none
  std::unique_ptr<adapters::web::PageServer> pages_; // null: none
};

} // namespace parlour::tools
