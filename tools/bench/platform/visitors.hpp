// Visitors of one node, all at once: each has a seat and a conversation of its
// own, and all say the same. In virtual time, so that nothing is waited for and
// one thread does all the work.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "actors/node/node.hpp"
#include "tools/parlour/application/application.hpp"
#include "tools/parlour/application/data_folder.hpp"

namespace parlour::tools {

class Visitors {
public:
  // A node for the application, whose databases are in memory. An error if it
  // does not start.
  static Expected<Visitors> arrive(const Application& application);

  // So many more open a conversation each.
  void open(std::size_t count);
  // Nobody says anything for so long.
  void wait(Milliseconds time);
  // Everybody says this, one after the other, and is answered.
  void say(const std::vector<std::string>& turns);

  std::size_t count() const {
    return seats_.size();
  }
  // What a visitor has been told, one line for each output.
  const std::string& told(std::size_t visitor) const {
    return (*told_)[visitor];
  }
  // How many were told something else than the first.
  std::size_t misled() const;

private:
  Visitors(DataFolder data, std::unique_ptr<actors::Node> node)
      : data_(std::move(data)), node_(std::move(node)) {}

  DataFolder data_;
  // The seats' callbacks refer to it.
  std::unique_ptr<std::vector<std::string>> told_ =
      std::make_unique<std::vector<std::string>>();
  std::vector<actors::SeatId> seats_;
  std::unique_ptr<actors::Node> node_; // last: it is destroyed first
};

} // namespace parlour::tools
