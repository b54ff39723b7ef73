// Descriptor owns a file descriptor of the operating system and closes it.
#pragma once

#include <utility>

namespace parlour {

class Descriptor {
public:
  // A negative number: there is none.
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();

  int get() const {
    return number_;
  }
  // Gives the descriptor to the caller, who closes it.
  int release() {
    return std::exchange(number_, -1);
  }
  explicit operator bool() const {
    return number_ >= 0;
  }

private:
  int number_;
};

} // namespace parlour
