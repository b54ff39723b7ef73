// BlockCache: an allocator for small blocks that come and go at a high rate,
// such as call frames, strings and syntax nodes. Freed blocks stay in lists of
// their thread and are reused without a lock. Each list is bounded.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace parlour::script {

// One instance per thread. Blocks are grouped in classes of 16 bytes;
// `free_[c]` is a linked list that is threaded through the free blocks
// themselves. A block may be given back by another thread than the one that
// took it: it then moves to that thread's cache.
class BlockCache {
public:
  // Returns at least `bytes` bytes, aligned as malloc aligns. Throws
  // std::bad_alloc.
  static void* take(std::size_t bytes) {
    const auto size = class_of(bytes);
    auto& cache = local();
    if (size < classes && cache.free_[size]) {
      assert(cache.count_[size] > 0 && cache.count_[size] <= kept);
      auto* block = cache.free_[size];
      cache.free_[size] = block->next;
      --cache.count_[size];
      return block;
    }
    return fresh(bytes, size);
  }

  // `bytes` must be what the block was taken with.
  static void give(void* block, std::size_t bytes) {
    const auto size = class_of(bytes);
    auto& cache = local();
    if (size >= classes || cache.count_[size] >= kept)
      return std::free(block);
    auto* link = static_cast<Link*>(block);
    link->next = cache.free_[size];
    cache.free_[size] = link;
    ++cache.count_[size];
  }

private:
  struct Link {
    Link* next;
  };
  // malloc of glibc needs 8 bytes of each block itself and rounds to 16, so
  // blocks of 16n + 8 bytes waste nothing.
  static constexpr std::size_t step = 16;
  static constexpr std::size_t extra = 8;
  static constexpr std::size_t classes = 32; // up to 504 bytes
#ifdef __SANITIZE_ADDRESS__
  static constexpr unsigned kept = 0; // so that AddressSanitizer sees misuse
#else
  static constexpr unsigned kept = 64; // blocks of each class
#endif

  ~BlockCache() {
    for (auto* block : free_)
      while (block) {
        auto* next = block->next;
        std::free(block);
        block = next;
      }
  }
  // The class whose blocks are the smallest that fit.
  static std::size_t class_of(std::size_t bytes) {
    return (bytes + step - 1 - extra) / step;
  }
  // Blocks that are larger than all classes come from malloc and go back to it.
  static void* fresh(std::size_t bytes, std::size_t size) {
    auto* block = std::malloc(size < classes ? size * step + extra : bytes);
    if (!block)
      throw std::bad_alloc();
    return block;
  }
  // The cache of this thread; it frees its blocks when the thread ends.
  static BlockCache& local() {
    static thread_local BlockCache cache;
    return cache;
  }

  Link* free_[classes] = {};
  unsigned count_[classes] = {};
};

} // namespace parlour::script
