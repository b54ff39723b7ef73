// NoDescriptors: while it lives, the process can open no further files.
#pragma once

#include <stdexcept>

#include <sys/resource.h>

namespace parlour::test {

class NoDescriptors {
public:
  // Descriptors below `first_refused` may still be opened.
  explicit NoDescriptors(int first_refused = 0) {
    if (getrlimit(RLIMIT_NOFILE, &former_) != 0)
      throw std::runtime_error("the limit of files cannot be read");
    const rlimit none{static_cast<rlim_t>(first_refused), former_.rlim_max};
    if (setrlimit(RLIMIT_NOFILE, &none) != 0)
      throw std::runtime_error("the limit of files cannot be set");
  }
  NoDescriptors(const NoDescriptors&) = delete;
  NoDescriptors& operator=(const NoDescriptors&) = delete;
  ~NoDescriptors() {
    setrlimit(RLIMIT_NOFILE, &former_);
  }

private:
  rlimit former_{};
};

} // namespace parlour::test
