// Fifo: what comes first goes first. Unlike std::deque it takes no memory until
// it is used, and none again and again: most sessions' queues are empty.
#pragma once

#include <cstddef>
#include <utility>

#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

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
  void push_front(T item) {
    if (first_ > 0)
      items_[--first_] = std::move(item);
    else
      items_.insert(items_.begin(), std::move(item));
  }
  T take() { // the first one
    auto item = std::move(items_[first_++]);
    tidy();
    return item;
  }
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

private:
  // The taken ones in front are given up when they are more than the rest.
  void tidy() {
    if (empty())
      clear();
    else if (first_ > 16 && first_ > size()) {
      items_.erase(items_.begin(), begin());
      first_ = 0;
    }
  }

  ShortLivedList<T> items_;
  std::size_t first_ = 0; // those before were taken
};

} // namespace parlour::dialogue
