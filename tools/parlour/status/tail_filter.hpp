// TailFilter: which inspections `parlour tail` wants to see, and how it shows
// them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/message/inspection.hpp"

namespace parlour::tools {

// The roles of each component of an application, by its name.
using RolesByComponent = std::map<std::string, std::vector<std::string>>;

// What is empty is not asked for.
struct TailFilter {
  std::string session = {};
  std::vector<std::string> kinds =
      {}; // of inspections; empty: all but coverage
  // Components or roles: a name means those that fill the role, and the other
  // way round. Messages only.
  std::string from = {};
  std::string to = {};

  bool takes(const Inspection& seen, const RolesByComponent& roles) const;
};

// The names of all kinds.
std::vector<std::string> inspection_kinds();

std::string to_json(const TailFilter& filter);
Expected<TailFilter> filter_from_json(const std::string& text);

// "09:00:00.000  s1  3  message     ASR.RecognitionResult(hello)  [session]":
// time, session, turn (- where there is none), then as `--trace` shows it.
std::string tail_line(const Inspection& seen, Timestamp now);

} // namespace parlour::tools
