// Journal: where a node keeps what enters its sessions, so that each can be
// repeated and can go on after a crash (engine rules 7.10 and 7.11).
// adapters/journal implements it by a folder of files.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "runtime/base/metrics.hpp"

namespace parlour {

// All of it from any thread.
class Journal {
public:
  // A stretch of the journal, which is not thrown away while somebody holds it.
  struct Part {
    std::uint64_t number = 0; // rising
  };
  struct Place {
    std::uint64_t record = 0; // rising; 0: it could not be kept, and is lost
    std::uint64_t part = 0;   // where it stands
  };

  virtual ~Journal() = default;

  // Keeps a record as it is; returns at once. What is lost is counted and told
  // by whoever made the journal.
  virtual Place append(std::string record) = 0;
  // Calls `done` once this record and all before it are written: from a thread
  // of the journal, or at once. Not called where they never are.
  virtual void when_written(std::uint64_t record,
                            std::function<void()> done) = 0;
  // Nobody is called any more, on return, for what was asked before.
  virtual void forget_who_waits() = 0;
  // The part where the next record will stand; later ones follow it.
  virtual std::shared_ptr<const Part> hold() = 0;
  // What it counts.
  virtual Metrics metrics() const {
    return {};
  }
};

} // namespace parlour
