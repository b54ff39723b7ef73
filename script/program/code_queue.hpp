// CodeQueue holds the pieces of code that a search through calls has still to
// look at. Each is given out once, as functions may call each other in a ring,
// and those found first come first.
//
//  CodeQueue<Item> queue(program);
//  queue.add({code, …});
//  while (const auto next = queue.take()) …
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "script/program/program.hpp"

namespace parlour::script {

// An `Item` has a member `code`, and what else the search has to know of it.
template <class Item>
class CodeQueue {
public:
  explicit CodeQueue(const Program& program) : seen_(program.code.size()) {}

  // Ignores no_code, and code that was added before.
  void add(Item item) {
    if (item.code >= seen_.size() || seen_[item.code])
      return;
    seen_[item.code] = true;
    waiting_.push_back(std::move(item));
  }

  std::optional<Item> take() {
    if (waiting_.empty())
      return {};
    std::optional<Item> next(std::move(waiting_.front()));
    waiting_.pop_front();
    return next;
  }

private:
  std::vector<bool> seen_;
  std::deque<Item> waiting_;
};

} // namespace parlour::script
