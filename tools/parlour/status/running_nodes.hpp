// The nodes that this user runs, and how one of them is asked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/outside/descriptor.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

namespace questions {
inline constexpr const char* who = "who";
inline constexpr const char* status = "status";
inline constexpr const char* metrics = "metrics";
// Of these a blank and JSON follow: a filter, a reload_request.
inline constexpr const char* tail = "tail";
inline constexpr const char* reload = "reload";
} // namespace questions

struct RunningNode {
  std::string application; // its name
  std::string folder;      // absolute
  std::int64_t process = 0;
  std::filesystem::path socket = {}; // where it is asked
};

std::string to_json(const RunningNode& node);
Expected<RunningNode> node_from_json(const std::string& text);

// Whether `app` names this node: by its name or its folder. Nothing names all.
bool is_meant(const Places& places, const std::string& app,
              const std::string& application, const std::string& folder);
// "; running: receptionist, butler"; empty for none.
std::string also_running(const std::vector<std::string>& applications);

// The one that is meant. The error says that it does not run, or that there are
// several.
Expected<RunningNode> the_node(const Places& places, const std::string& app);

// Longer than a node waits for its actors.
inline constexpr Milliseconds usual_patience{3'000};

// Connects and asks. The error has the kind Network.
Expected<Descriptor> ask(const std::filesystem::path& socket,
                         const std::string& question,
                         Milliseconds patience = usual_patience);
// Waits for all of the answer. The error has the kind Timeout.
Expected<std::string> answer_to(const std::filesystem::path& socket,
                                const std::string& question,
                                Milliseconds patience = usual_patience);
// Of each whose socket is in the folder, in the order of their processes. A
// socket that nobody listens at is removed: its process was killed.
std::vector<Expected<std::string>>
answers_to(const std::filesystem::path& folder, const std::string& question);

} // namespace parlour::tools
