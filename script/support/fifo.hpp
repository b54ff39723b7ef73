// Fifo: a queue in one block of memory. Unlike std::deque it allocates nothing
// while it is empty, and an element that comes and goes costs no allocation.
// Most queues of a session are empty most of the time.
#pragma once

#include <cstddef>
#include <utility>

#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

// Elements before `first_` were taken already; their memory is reused or given
// up by tidy(). push_back and take are O(1) amortised; taking from the middle
// is linear. Not thread-safe.
template <class T>
class Fifo {
public:
  using Place = typename ShortLivedList<T>::iterator;

  bool empty() const {
    return first_ == items_.size();
  }
  std::size_t size() const {
    return items_.size() - first_;
  }
  // The queue must not be empty.
  T& front() {
    return items_[first_];
  }
  const T& front() const {
    return items_[first_];
  }
  auto begin() {
    return items_.begin() + static_cast<std::ptrdiff_t>(first_);
  }
  auto end() {
    return items_.end();
  }
  auto begin() const {
    return items_.begin() + static_cast<std::ptrdiff_t>(first_);
  }
  auto end() const {
    return items_.end();
  }

  void push_back(T item) {
    items_.push_back(std::move(item));
  }
  // Uses the space of an element that was taken, if there is any.
  void push_front(T item) {
    if (first_ > 0)
      items_[--first_] = std::move(item);
    else
      items_.insert(items_.begin(), std::move(item));
  }
  T take() { // the first element
    auto item = std::move(items_[first_++]);
    tidy();
    return item;
  }
  // Takes an element out of the middle.
  template <class Iterator>
  T take(Iterator which) {
    if (which == begin())
      return take();
    auto item = std::move(*which);
    items_.erase(which);
    return item;
  }
  void clear() {
    items_.clear();
    first_ = 0;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    items_.erase(items_.begin(), begin());
    first_ = 0;
    archive(items_);
  }

private:
  // Gives up the space in front when it exceeds the rest of the queue.
  void tidy() {
    if (empty())
      clear();
    else if (first_ > 16 && first_ > size()) {
      items_.erase(items_.begin(), begin());
      first_ = 0;
    }
  }

  ShortLivedList<T> items_;
  std::size_t first_ = 0; // the index of the front; what lies before was taken
};

} // namespace parlour::dialogue
