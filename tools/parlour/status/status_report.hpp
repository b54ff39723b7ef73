// StatusReport: what `parlour status` tells of one running node. Between the
// processes it is JSON (docs/running.md, "How it is").
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "actors/protocol/actor_status.hpp"
#include "runtime/base/error.hpp"

namespace parlour::tools {

struct StatusReport {
  std::string application; // its name
  std::string folder;      // absolute
  std::int64_t process = 0;
  Timestamp time = 0; // of the node
  std::vector<actors::ActorStatus> actors;
};

std::string to_json(const StatusReport& report);
// An error where the text is no such report.
Expected<StatusReport> report_from_json(const std::string& text);

// A heading, and a line for each actor.
void print_table(std::ostream& out, const StatusReport& report);
// An array of reports.
void print_json(std::ostream& out, const std::vector<StatusReport>& reports);

} // namespace parlour::tools
