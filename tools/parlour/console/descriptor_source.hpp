// DescriptorSource: a ByteSource (row_reader.hpp) on a file descriptor, such as
// standard input.
#pragma once

#include "tools/parlour/console/row_reader.hpp"

namespace parlour::tools {

class DescriptorSource : public ByteSource {
public:
  // Reads from `input`; reading ends as interrupted as soon as `interrupt` is
  // readable, such as SignalWatch::descriptor(). Owns neither descriptor.
  DescriptorSource(int input, int interrupt)
      : input_(input), interrupt_(interrupt) {}

  // Blocks for `patience` at most, or without limit if it is empty.
  Read read(std::optional<Milliseconds> patience) override;

private:
  int input_;
  int interrupt_;
};

} // namespace parlour::tools
