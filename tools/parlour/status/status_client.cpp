#include "tools/parlour/status/status_client.hpp"

#include "tools/parlour/status/running_nodes.hpp"

namespace parlour::tools {

std::vector<Expected<StatusReport>>
ask_status(const std::filesystem::path& folder) {
  std::vector<Expected<StatusReport>> all;
  for (const auto& answer : answers_to(folder, questions::status))
    all.push_back(answer ? report_from_json(*answer)
                         : tl::make_unexpected(answer.error()));
  return all;
}

} // namespace parlour::tools
