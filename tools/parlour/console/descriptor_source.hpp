// Bytes of a file descriptor, until there are no more or a signal comes.
#pragma once

#include "tools/parlour/console/row_reader.hpp"

namespace parlour::tools {

class DescriptorSource : public ByteSource {
public:
  // Reads `input`; interrupted when `interrupt` becomes readable. Owns neither.
  DescriptorSource(int input, int interrupt)
      : input_(input), interrupt_(interrupt) {}

  Read read(std::optional<Milliseconds> patience) override;

private:
  int input_;
  int interrupt_;
};

} // namespace parlour::tools
