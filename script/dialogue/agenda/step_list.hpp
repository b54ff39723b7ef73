// StepList: steps in their order. A step is made once and stays where it is:
// lists are put in front of one another, and steps taken, by pointers alone.
// Most lists are short and live for a moment, so the nodes come from the
// thread's BlockCache.
#pragma once

#include <concepts>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

#include "script/dialogue/agenda/step.hpp"
#include "script/support/block_cache.hpp"

namespace parlour::dialogue {

// Owns its steps; can be moved, not copied. Not thread-safe.
class StepList {
  // One step and the next one. The list owns it, or whoever has taken it.
  struct Node {
    template <class Kind>
    explicit Node(std::in_place_t, Kind&& kind)
        : step(std::forward<Kind>(kind)) {}

    static void* operator new(std::size_t size) {
      return script::BlockCache::take(size);
    }
    static void operator delete(void* node, std::size_t size) {
      script::BlockCache::give(node, size);
    }

    Step step;
    Node* next = nullptr;
  };

  template <class Item>
  class Place {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Step;
    using difference_type = std::ptrdiff_t;
    using pointer = Item*;
    using reference = Item&;

    explicit Place(Node* node = nullptr) : node_(node) {}
    Item& operator*() const {
      return node_->step;
    }
    Item* operator->() const {
      return &node_->step;
    }
    Place& operator++() {
      node_ = node_->next;
      return *this;
    }
    Place operator++(int) {
      auto before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Place&) const = default;

  private:
    Node* node_;
  };

public:
  // A step that was taken out; whoever holds it owns it.
  using Taken = std::unique_ptr<Node>;

  StepList() = default;
  template <class... Kinds>
  requires(sizeof...(Kinds) > 0 && (std::constructible_from<Step, Kinds> &&
                                    ...)) StepList(Kinds&&... kinds) {
    (add(std::forward<Kinds>(kinds)), ...);
  }
  StepList(StepList&& other) noexcept
      : first_(std::exchange(other.first_, nullptr)),
        last_(std::exchange(other.last_, nullptr)) {}
  // What this list had is with the other one afterwards, and is freed with it.
  StepList& operator=(StepList&& other) noexcept {
    std::swap(first_, other.first_);
    std::swap(last_, other.last_);
    return *this;
  }
  ~StepList() {
    if (!empty())
      clear();
  }

  bool empty() const {
    return first_ == nullptr;
  }
  // The list must not be empty.
  const Step& back() const {
    return last_->step;
  }
  auto begin() {
    return Place<Step>(first_);
  }
  auto end() {
    return Place<Step>();
  }
  auto begin() const {
    return Place<const Step>(first_);
  }
  auto end() const {
    return Place<const Step>();
  }

  // At the end: a step of whatever kind.
  template <class Kind>
  Step& add(Kind&& kind) {
    auto* node = new Node(std::in_place, std::forward<Kind>(kind));
    append(node, node);
    return node->step;
  }
  // In constant time, and the other list is empty afterwards; prepend, too.
  void append(StepList&& other) {
    if (!other.empty())
      append(std::exchange(other.first_, nullptr),
             std::exchange(other.last_, nullptr));
  }
  const Step& append(Taken taken) {
    auto* node = taken.release();
    node->next = nullptr;
    append(node, node);
    return node->step;
  }
  void prepend(StepList&& other) {
    other.append(std::move(*this));
    *this = std::move(other);
  }

  // The first one; there must be one.
  Taken take() {
    auto* node = std::exchange(first_, first_->next);
    if (!first_)
      last_ = nullptr;
    return Taken(node);
  }
  // Those for which `wanted` says so, in their order.
  template <class Predicate>
  StepList take_if(Predicate wanted) {
    StepList taken;
    StepList left;
    while (!empty()) {
      auto first = take();
      const bool is_wanted = wanted(std::as_const(first->step));
      (is_wanted ? taken : left).append(std::move(first));
    }
    *this = std::move(left);
    return taken;
  }
  void clear() {
    while (!empty())
      take();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& step : *this)
      ++count;
    archive.without(first_, last_); // they hold the steps
    archive.each(
        *this, count, [&]() -> Step& { return add(steps::End()); },
        [&](Step& step) { archive(step); });
  }

private:
  void append(Node* first, Node* last) {
    (last_ ? last_->next : first_) = first;
    last_ = last;
  }

  Node* first_ = nullptr;
  Node* last_ = nullptr; // null: empty
};

} // namespace parlour::dialogue
