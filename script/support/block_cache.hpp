// Small blocks of memory, given back to a cache of the thread: frames and
// strings come and go at a rate where malloc is felt. The cache is bounded.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace parlour::script {

class BlockCache {
public:
  static void* take(std::size_t bytes) {
    const auto size = class_of(bytes);
    auto& cache = local();
    if (size < classes && cache.free_[size]) {
      auto* block = cache.free_[size];
      cache.free_[size] = block->next;
      --cache.count_[size];
      return block;
    }
    return fresh(bytes, size);
  }

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
  static constexpr std::size_t step = 16;
  static constexpr std::size_t extra = 8;
  static constexpr std::size_t classes = 32; // up to 504 bytes
#ifdef __SANITIZE_ADDRESS__
  static constexpr unsigned kept = 0; // so that misuse is seen
#else
  static constexpr unsigned kept = 64;
#endif

  ~BlockCache() {
    for (auto* block : free_)
      while (block) {
        auto* next = block->next;
        std::free(block);
        block = next;
      }
  }
  // As large as what malloc takes anyhow.
  static std::size_t class_of(std::size_t bytes) {
    return (bytes + step - 1 - extra) / step;
  }
  static void* fresh(std::size_t bytes, std::size_t size) {
    auto* block = std::malloc(size < classes ? size * step + extra : bytes);
    if (!block)
      throw std::bad_alloc();
    return block;
  }
  static BlockCache& local() {
    static thread_local BlockCache cache;
    return cache;
  }

  Link* free_[classes] = {};
  unsigned count_[classes] = {};
};

} // namespace parlour::script
