// Allocators for small objects that live for a turn or less. Their memory comes
// from the thread's BlockCache.
//
// What outlives a turn, or moves between threads a lot, is better off with the
// standard allocator.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "script/support/block_cache.hpp"

namespace parlour::dialogue {

// A standard allocator; stateless, so all instances are interchangeable.
template <class T>
struct ShortLived {
  using value_type = T;

  ShortLived() = default;
  template <class Other>
  explicit ShortLived(const ShortLived<Other>&) {}

  T* allocate(std::size_t count) {
    // NOLINTNEXTLINE(bugprone-sizeof-expression): T may be a pointer
    return static_cast<T*>(script::BlockCache::take(count * sizeof(T)));
  }
  void deallocate(T* first, std::size_t count) {
    // NOLINTNEXTLINE(bugprone-sizeof-expression): T may be a pointer
    script::BlockCache::give(first, count * sizeof(T));
  }
  bool operator==(const ShortLived&) const = default;
};

template <class T>
using ShortLivedList = std::vector<T, ShortLived<T>>;

// Like std::make_shared, with object and reference count in one cached block.
template <class T, class... Arguments>
std::shared_ptr<T> make_short_lived(Arguments&&... arguments) {
  return std::allocate_shared<T>(ShortLived<std::remove_const_t<T>>(),
                                 std::forward<Arguments>(arguments)...);
}

} // namespace parlour::dialogue
