// Coverage: the states, transitions, topics, slots, handlers and branches of an
// application that its conversations reach.
#pragma once

#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "runtime/message/inspection.hpp"
#include "script/program/program.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

class Coverage {
public:
  // Nothing is reached yet. `program` must outlive this.
  explicit Coverage(const script::Program& program);

  // Notes what an inspection of a node shows. Not thread-safe.
  void note(const Inspection& inspection);
  // Adds what another coverage of the same program has seen.
  void add(const Coverage& other);

  // One kind of things, for example all states.
  struct Part {
    std::string name; // "states"
    std::size_t all = 0;
    std::vector<std::string> missing; // in the program's order
  };
  // The kinds, in the order in which they are printed.
  std::vector<Part> parts() const;

private:
  Part handlers() const;
  Part part(const char* name, const std::vector<std::string>& all,
            const std::set<std::string>& reached) const;

  const script::Program* program_;
  std::set<std::string> states_;
  std::set<std::string> topics_;
  std::set<std::string> slots_;
  // "file:line" of branches, handlers and transitions.
  std::set<std::string> places_;
};

// Prints the counts, and everything that is not reached. Files below the
// working folder are shown relative to it.
void print(std::ostream& out, const Coverage& coverage, const Places& places);

} // namespace parlour::tools
