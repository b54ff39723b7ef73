// Journal: where a node keeps what enters its sessions, so that each can be
// repeated (engine rule 7.2). adapters/journal implements it by a file.
#pragma once

#include <string>

namespace parlour {

class Journal {
public:
  virtual ~Journal() = default;

  // Keeps a record as it is. From any thread; returns at once. What cannot be
  // kept is counted and told by whoever made the journal: a conversation does
  // not wait for it.
  virtual void append(std::string record) = 0;
};

} // namespace parlour
