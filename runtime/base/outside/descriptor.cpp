#include "runtime/base/outside/descriptor.hpp"

#include <unistd.h>

namespace parlour {

Descriptor::~Descriptor() {
  if (number_ >= 0)
    close(number_);
}

} // namespace parlour
