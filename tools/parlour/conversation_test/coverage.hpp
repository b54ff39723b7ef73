// Coverage: which states, transitions, topics, slots, handlers and branches of
// an application its conversations reach.
#pragma once

#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "runtime/base/inspection.hpp"
#include "script/program/program.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

class Coverage {
public:
  // The program must outlive this.
  explicit Coverage(const script::Program& program);

  void note(const Inspection& inspection);
  // What another one of the same program has seen.
  void add(const Coverage& other);

  struct Part {
    std::string name; // "states"
    std::size_t all = 0;
    std::vector<std::string> missing; // in the order of the program
  };
  std::vector<Part> parts() const;

private:
  Part handlers() const;
  Part part(const char* name, const std::vector<std::string>& all,
            const std::set<std::string>& reached) const;

  const script::Program* program_;
  std::set<std::string> states_;
  std::set<std::string> topics_;
  std::set<std::string> slots_;
  std::set<std::string> places_; // of branches, handlers, transitions
};

// Files below the working folder are named from there.
void print(std::ostream& out, const Coverage& coverage, const Places& places);

} // namespace parlour::tools
